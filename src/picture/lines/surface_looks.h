/* The views of a picture of lines on surfaces, and where they stand on the sheet. */
#ifndef BAT_PICTURE_LINES_SURFACE_LOOKS_H
#define BAT_PICTURE_LINES_SURFACE_LOOKS_H
#include "picture/lines/wires.h"
#include "picture/sheet/axes.h"
#include "picture/sheet/size.h"

enum { BAT_MOST_VIEWS = 4 };

/* One drawing on the sheet. */
typedef struct {
    batten_view kind;
    bat_eye eye;
    const char *title;
    double low[2], high[2]; /* what it shows, before scaling */
    bat_plot plot;
} bat_look;

typedef struct {
    const batten_draw_options *options;
    bat_wires wires;
    int look_count;
    bat_look looks[BAT_MOST_VIEWS];
    double em;
    int height; /* of the sheet, after bat_looks_place */
} bat_looks_drawing;

void bat_looks_choose(bat_looks_drawing *d);
/* The lines themselves, more exact than the box. */
void bat_looks_measure_lines(const bat_looks_drawing *d, bat_look *l);
/* What a look shows: the corners of the box. Fails where one is behind the eye. */
batten_status bat_look_measure(const bat_looks_drawing *d, bat_look *l);
/* Place the looks on the sheet, whose height follows them where none was asked for. */
void bat_looks_place(bat_looks_drawing *d);

#endif
