/* Tables of half-breadths on waterlines, from a function. */
#ifndef TEST_WATERLINES_H
#define TEST_WATERLINES_H
#include "support/test.h"
#include <batten/hull.h>

/* y at a place; NAN for a blank. */
typedef double (*half_breadth)(double x, double z);

enum { WATERLINES_MOST = 24 };

static inline batten_offset_table *make_waterlines(int stations, const double *x, int lines,
                                                   const double *z, half_breadth of)
{
    static batten_table_point points[WATERLINES_MOST][WATERLINES_MOST];
    batten_table_station at[WATERLINES_MOST];
    batten_table_line line[WATERLINES_MOST];
    batten_offset_table *table = NULL;
    for (int l = 0; l < lines; l++)
        line[l] = (batten_table_line){"", true, z[l]};
    for (int k = 0; k < stations; k++) {
        int count = 0;
        for (int l = 0; l < lines; l++)
            if (!isnan(of(x[k], z[l])))
                points[k][count++] = (batten_table_point){x[k], of(x[k], z[l]), z[l], l};
        at[k] = (batten_table_station){"", x[k], count, points[k]};
    }
    CHECK_OK(batten_offset_table_create(1, lines, line, stations, at, &table));
    return table;
}

#endif
