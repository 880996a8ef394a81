/* A drawing in DXF: the lines and texts of a sheet on layers, in the units of the model. */
#ifndef BAT_SHEET_DXF_H
#define BAT_SHEET_DXF_H
#include "base/base.h"
#include <batten/text.h>

/* Stations, buttocks, waterlines and diagonals are in the order of their families. */
typedef enum {
    BAT_LAYER_STATIONS,
    BAT_LAYER_BUTTOCKS,
    BAT_LAYER_WATERLINES,
    BAT_LAYER_DIAGONALS,
    BAT_LAYER_EDGES,
    BAT_LAYER_POINTS,
    BAT_LAYER_GRID,
    BAT_LAYER_TEXT,
    BAT_LAYER_TABLE,
    BAT_LAYER_SHEET,
    BAT_LAYERS
} bat_layer;

typedef struct {
    batten_text file;
    double scale; /* points of the sheet for a unit */
    double x, y;  /* where the origin of the model lies on the sheet, points */
    bat_layer layer;
} bat_dxf_sheet;

/* A text, its lower left or middle point or its right end at the height of the middle of its letters. */
typedef struct {
    double size, x, y; /* points */
    int anchor;        /* 0 left, 1 middle, 2 right */
    const char *text;
} bat_dxf_letters;

/* A file without entities. */
bat_dxf_sheet bat_dxf_sheet_begin(void);
/* A polyline through xy [count][2], points of the sheet, on the layer of now. */
void bat_dxf_sheet_line(bat_dxf_sheet *sheet, size_t count, const double *xy);
/* On the layer of now where that is the table, else with the other texts. */
void bat_dxf_sheet_text(bat_dxf_sheet *sheet, const bat_dxf_letters *letters);
/* Hand the file over; the sheet is gone in either case. */
batten_status bat_dxf_sheet_finish(bat_dxf_sheet *sheet, char **data, size_t *size);
void bat_dxf_sheet_free(bat_dxf_sheet *sheet);

#endif
