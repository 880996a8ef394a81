/* A .ftm file while it is read. */
#ifndef BAT_FTM_READING_H
#define BAT_FTM_READING_H
#include "exchange/ftm/ftm.h"
#include "exchange/reading/census.h"

enum {
    BAT_FTM_LINES_OF_POINT = 4, /* x y z; kind; two marks */
    BAT_FTM_LINES_OF_EDGE = 4,  /* two points; crease; a mark */
    BAT_FTM_LINES_OF_LAYER = 12,
    BAT_FTM_CORNERS = 100,
    BAT_FTM_NAME = 128
};

typedef struct {
    bat_input *input;
    bat_list lines; /* of uint32_t: where each begins in the file */
    size_t points;  /* the line with the number of points */
    int point_count, layer_count, curve_count, crease_count;
    size_t cut_up;       /* faces of more than three corners */
    size_t layers;       /* the first line of the first layer; meaningless without layers */
    size_t at;           /* the next line */
    double *coordinates; /* [point_count][3] */
    bat_list corners;    /* of int: triangles, [3] each, */
    bat_list owners;     /* of int: and the layer of each */
    int *order;          /* the triangles by layers, */
    int *ends;           /* and where each layer ends there */
    bat_census census;
    batten_model *model;
} bat_ftm_reading;

/* Lines are short: a span for each would take several times the file. */
batten_status bat_ftm_split_lines(bat_ftm_reading *r);
bat_span bat_ftm_line_of(const bat_ftm_reading *r, size_t index);
/* The numbers of a line, at most `most`; -1 when something else stands there. */
int bat_ftm_numbers_of(bat_span line, int most, double *values);
bool bat_ftm_is_whole(const bat_ftm_reading *r, size_t index, int *value);
/* A whole number from `low` to `high` in the next line. */
batten_status bat_ftm_next_whole(bat_ftm_reading *r, const char *what, int low, int high,
                                 int *value);
/* A count of things of `least` lines each: they must fit into the lines that are left. */
batten_status bat_ftm_next_count(bat_ftm_reading *r, const char *what, size_t least,
                                 int *count);

/* Of all the lines only those of the layers are looked at again. */
void bat_ftm_drop_lines(bat_ftm_reading *r);
batten_status bat_ftm_add_layers(bat_ftm_reading *r);

#endif
