/* What Numba's code asks of its runtime, for one thread: arrays with counted references.
 *
 * The struct is what the code itself reads (numba/core/runtime/nrtdynmod.py): a count, a destructor with its
 * argument, the data, its size. Arrays of numbers have no destructor.
 */
#include <stdint.h>
#include <stdlib.h>

typedef struct {
    uint64_t count;
    void *destructor;
    void *argument;
    void *data;
    uint64_t size;
    void *allocator;
} Block;

void *NRT_MemInfo_alloc_aligned(int64_t size, int32_t align)
{
    Block *block = malloc(sizeof(Block) + (size_t)size + (size_t)align);
    if (!block)
        return 0;
    uintptr_t place = (uintptr_t)(block + 1);
    place = (place + (uintptr_t)align - 1) / (uintptr_t)align * (uintptr_t)align;
    block->count = 1;
    block->destructor = 0;
    block->argument = 0;
    block->data = (void *)place;
    block->size = (uint64_t)size;
    block->allocator = 0;
    return block;
}

void *NRT_MemInfo_alloc_safe_aligned(int64_t size, int32_t align)
{
    return NRT_MemInfo_alloc_aligned(size, align);
}

void NRT_MemInfo_call_dtor(void *block)
{
    free(block);
}

void *NRT_MemInfo_alloc(int64_t size)
{
    return NRT_MemInfo_alloc_aligned(size, 16);
}

void *NRT_Allocate(int64_t size)
{
    return malloc((size_t)size);
}

void NRT_Free(void *place)
{
    free(place);
}

/* Where Numba's own code reports what cannot happen here: the entry's status tells that it was left. */
void *PyExc_RuntimeError = 0;

void PyErr_SetString(void *kind, const char *text)
{
    (void)kind;
    (void)text;
}

/* Lists, with which Numba words what is wrong where shapes of arrays do not agree: none is made, which it takes as an error. */
void *NRT_MemInfo_new_varsize_dtor(int64_t size, void *destructor)
{
    (void)size;
    (void)destructor;
    return 0;
}

void *NRT_MemInfo_varsize_realloc(void *block, int64_t size)
{
    (void)block;
    (void)size;
    return 0;
}
