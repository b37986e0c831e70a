/* The kernel's own entries as a program, for any processor: numbers of scenarios in, heads, events and samples out.
 *
 * PROGRAM IN OUT CELL CONTACT EVENT SEGMENT ROW HEADS COLUMNS STATES SAMPLES BUFFER STEPS LIMIT
 * For each scenario IN holds 1 for compliant contact or 0, the cell and the contact; OUT takes the heads, the records of events
 * and, of a motion that lasts, the rows of samples. EVENT, SEGMENT and ROW are sizes in bytes, BUFFER is a status, LIMIT the place of
 * `max_events` in the cell; the others are counts.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int motion(void *cell, void *events, unsigned most_events, void *segments, unsigned most_segments, void *table, void *heads);
int samples(void *cell, void *segments, unsigned count, void *times, unsigned n, unsigned left, void *out);
int compliant_motion(void *cell, void *contact, void *events, unsigned most_events, unsigned most_steps, void *rows,
                     unsigned most_rows, void *table, void *heads);
int compliant_samples(void *cell, void *contact, void *rows, unsigned count, void *times, unsigned n, unsigned left, void *out);

static void *room(size_t count, size_t size)
{
    void *place = malloc(count * size);
    if (!place) {
        fputs("There is not enough memory.\n", stderr);
        exit(2);
    }
    return place;
}

int main(int count, char **words)
{
    unsigned given[12];
    if (count != 15)
        return 2;
    for (int k = 0; k < 12; k++)
        given[k] = (unsigned)strtoul(words[k + 3], NULL, 10);
    unsigned cells = given[0], contacts = given[1], event = given[2], segment = given[3], row = given[4], heads = given[5];
    unsigned columns = given[6], states = given[7], instants = given[8], buffer = given[9], most_steps = given[10], limit = given[11];
    FILE *in = fopen(words[1], "rb"), *out = fopen(words[2], "wb");
    if (!in || !out)
        return 2;
    double *line = room(1 + cells + contacts, sizeof(double)), *head = room(heads, sizeof(double));
    double *times = room(instants, sizeof(double)), *found = room((size_t)instants * states, sizeof(double));
    unsigned most_events = 256, most_pieces[2] = {4096, 4096}, size[2] = {segment, row};
    while (fread(line, sizeof(double), 1 + cells + contacts, in) == 1 + cells + contacts) {
        int soft = line[0] != 0.0;
        double *cell = line + 1, *contact = cell + cells;
        for (;;) {
            void *events = room(most_events, event), *table = room((size_t)most_events * columns, sizeof(double));
            void *pieces = room(most_pieces[soft], size[soft]);
            int failed = soft ? compliant_motion(cell, contact, events, most_events, most_steps, pieces, most_pieces[1], table, head)
                              : motion(cell, events, most_events, pieces, most_pieces[0], table, head);
            if (failed) {
                fprintf(stderr, "The kernel ended with %d.\n", failed);
                return 1;
            }
            /* of a motion with compliant contact the heads hold how many pieces it takes */
            int pressed = (unsigned)head[0] == buffer, crowded = head[1] == most_events && most_events < cell[limit];
            unsigned filled = (unsigned)head[2];
            if (!pressed && !crowded) {
                fwrite(head, sizeof(double), heads, out);
                fwrite(events, event, (size_t)head[1], out);
                if (head[3] > 0.0) {
                    for (unsigned k = 0; k < instants; k++)
                        times[k] = head[3] * k / (instants - 1);
                    failed = soft ? compliant_samples(cell, contact, pieces, filled, times, instants, 0, found)
                                  : samples(cell, pieces, filled, times, instants, 0, found);
                    if (failed)
                        return 1;
                    fwrite(found, sizeof(double), (size_t)instants * states, out);
                }
            }
            free(events);
            free(table);
            free(pieces);
            if (pressed)
                most_pieces[soft] = soft ? filled : 4 * most_pieces[0];
            else if (crowded)
                most_events *= 4;
            else
                break;
        }
    }
    return fclose(out) ? 1 : 0;
}
