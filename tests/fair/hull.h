/* Tables of offsets for the tests of fairing. */
#ifndef TESTS_FAIR_HULL_H
#define TESTS_FAIR_HULL_H
#include "support/test.h"
#include <batten/fair.h>
#include <math.h>

enum { HULL_MOST = 1200, HULL_STATIONS = 80, HULL_LINES = 20 };

typedef struct {
    batten_table_point points[HULL_MOST];
    batten_table_station stations[HULL_STATIONS];
    batten_table_line lines[HULL_LINES];
    char names[HULL_LINES][16];
    int point_count, station_count, line_count;
} hull;

static inline int hull_line(hull *h, double z)
{
    for (int l = 0; l < h->line_count; l++)
        if (h->lines[l].z == z)
            return l;
    snprintf(h->names[h->line_count], sizeof h->names[0], "z=%g", z);
    h->lines[h->line_count] = (batten_table_line){h->names[h->line_count], true, z};
    return h->line_count++;
}

/* Points come station by station. */
static inline void hull_add(hull *h, double x, double y, double z, int line)
{
    if (h->station_count == 0 || h->stations[h->station_count - 1].x != x)
        h->stations[h->station_count++] =
            (batten_table_station){.name = "", .x = x, .points = h->points + h->point_count};
    h->stations[h->station_count - 1].point_count++;
    h->points[h->point_count++] = (batten_table_point){x, y, z, line};
}

/* Wigley's hull y = (1 - x^2) (1 - z^2) for x in (-1, 1), z in (-1, 0], L = 10, with noise. */
static inline hull *hull_wigley(int stations, int lines, double noise)
{
    hull *h = test_array(1, sizeof *h);
    test_random random = test_random_begin("wigley");
    for (int i = 0; i < stations; i++)
        for (int j = 0; j < lines; j++) {
            const double x = 1.8 * i / (stations - 1) - 0.9,
                         z = 0.9 * (j - lines + 1) / (lines - 1);
            const double y = (1 - x * x) * (1 - z * z) + noise * test_random_in(&random, -1, 1);
            hull_add(h, 5 * x, y, z, hull_line(h, z));
        }
    return h;
}

static inline batten_status hull_make(const hull *h, batten_offset_table **out)
{
    return batten_offset_table_create(1, h->line_count, h->lines, h->station_count, h->stations,
                                      out);
}

#endif
