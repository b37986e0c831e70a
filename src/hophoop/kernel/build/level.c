#include <stdint.h>

#if defined(__x86_64__)
static void cpuid(uint32_t leaf, uint32_t *found)
{
    __asm__ volatile("cpuid" : "=a"(found[0]), "=b"(found[1]), "=c"(found[2]), "=d"(found[3]) : "a"(leaf), "c"(0));
}

static int has(uint32_t word, uint32_t bits)
{
    return (word & bits) == bits;
}
#endif

/* Which library this processor can run: the level of x86-64 (its ABI's supplement), 1 for others. */
int32_t hophoop_level(void)
{
#if defined(__x86_64__)
    uint32_t found[4], state, high;
    cpuid(0, found);
    uint32_t last = found[0];
    cpuid(1, found);
    /* SSE3, SSSE3, CX16, SSE4.1, SSE4.2, POPCNT */
    if (!has(found[2], 1u << 0 | 1u << 9 | 1u << 13 | 1u << 19 | 1u << 20 | 1u << 23))
        return 1;
    /* FMA, MOVBE, OSXSAVE, AVX, F16C */
    if (last < 7 || !has(found[2], 1u << 12 | 1u << 22 | 1u << 27 | 1u << 28 | 1u << 29))
        return 2;
    __asm__ volatile("xgetbv" : "=a"(state), "=d"(high) : "c"(0));
    if (!has(state, 6))
        return 2;
    cpuid(7, found);
    /* BMI1, AVX2, BMI2 */
    if (!has(found[1], 1u << 3 | 1u << 5 | 1u << 8))
        return 2;
    cpuid(0x80000001u, found);
    return has(found[2], 1u << 5) ? 3 : 2; /* LZCNT */
#else
    return 1;
#endif
}
