/*
 * The points of a table of offsets as they come, in any order, and the table that they make.
 *
 * Stations are sorted by x. Points of a station are as they came where the table lists them one
 * by one with their lines: a sheer may run above a waterline here and below it there. Else they
 * are in the order of the mean heights of their lines, a point without a line in that of its
 * own height.
 */
#ifndef BAT_GATHER_H
#define BAT_GATHER_H
#include "exchange/reading/input.h"

typedef struct {
    double station; /* x of the station */
    double x, y, z;
    const char *station_name; /* NULL: its x */
    const char *line;         /* NULL: none, or with `by_height` the waterline of this height */
    int row;                  /* line of the file, for messages */
    int source;               /* the column or row that stands for the station; 0: none does */
    bool is_absent;           /* the station is there, the point is not */
} bat_gathered;

typedef struct {
    bat_input *input;
    double unit_metres;
    bool as_listed;  /* points of a station stay in the order in which they came */
    bool by_height;  /* points without a line belong to the waterline of their height */
    bat_list points; /* of bat_gathered */
    bat_list names;  /* of char *, owned */
} bat_gathering;

void bat_gather_begin(bat_gathering *gathering, bat_input *input);
void bat_gather_end(bat_gathering *gathering);
/* Keep a copy of a name as long as the gathering. */
batten_status bat_gather_name(bat_gathering *gathering, const char *text, const char **name);
batten_status bat_gather_point(bat_gathering *gathering, const bat_gathered *point);
/* A model with the one table. */
batten_status bat_gather_finish(bat_gathering *gathering, batten_model **out);

#endif
