/* A table of offsets while it is sorted into lines and stations. */
#ifndef BAT_CSV_GATHER_LINES_H
#define BAT_CSV_GATHER_LINES_H
#include "exchange/csv/gather.h"

/* A point on its way to its station. */
typedef struct {
    bat_gathered point;
    size_t order; /* as it came */
    int line;     /* its line, -1 for none */
    double rank;  /* mean height of its line, or its own; or the order as it came */
} bat_gather_sorted;

typedef struct {
    const char *name;
    bool is_waterline;
    double z, rank;
    size_t members; /* where its points stand, and how many, in the array sorted by lines */
    size_t count;
} bat_gather_line;

typedef struct {
    bat_gathering *from;
    size_t count;
    bat_gather_sorted *points;
    size_t line_count;
    bat_gather_line *lines;
    batten_table_line *offset_lines;
    batten_table_point *offset_points;
    batten_table_station *stations;
    int station_count;
    char (*line_texts)[BATTEN_NUMBER_SIZE + 2]; /* names made of numbers */
    char (*station_texts)[BATTEN_NUMBER_SIZE];
} bat_gather_table;

int bat_gather_compare(double a, double b);
int bat_gather_compare_order(size_t a, size_t b);
/* Find the lines, sort them by their mean height, and tell each point its line. */
batten_status bat_gather_find_lines(bat_gather_table *t);
void bat_gather_make_lines(bat_gather_table *t);

#endif
