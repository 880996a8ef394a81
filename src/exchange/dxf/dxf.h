/* Reading DXF of any release as text, and writing release 2000 (AC1015) or 2004 (AC1018). */
#ifndef BAT_DXF_H
#define BAT_DXF_H
#include "exchange/dxf/colours.h"
#include "exchange/reading/input.h"
#include <batten/exchange.h>
#include <batten/text.h>

batten_status bat_write_dxf(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text);

batten_status bat_dxf_recognise(const bat_input *input, bool *is_dxf);
batten_status bat_read_dxf(bat_input *input, batten_model **out);

/* The axes that the format gives to a plane with this unit normal; the origin is the world's.
 */
batten_frame bat_dxf_axes(batten_vec3 normal);
/* How many metres the unit of a number of $INSUNITS is, 0 for none; and the reverse. */
double bat_dxf_unit_of(int code);
int bat_dxf_code_of(double metres);

/* ---- groups (src/exchange/dxf/write_groups.c) ---- */

/* The file as it grows. */
typedef struct {
    batten_text text;
    int handle; /* the last one given */
} bat_dxf;

void bat_dxf_text(bat_dxf *dxf, int code, const char *value);
void bat_dxf_integer(bat_dxf *dxf, int code, int value);
void bat_dxf_real(bat_dxf *dxf, int code, double value);
/* x, y and z under `code`, code + 10, code + 20. */
void bat_dxf_point(bat_dxf *dxf, int code, const double point[3]);
/* A new handle under code 5, and that of the owner under 330. */
int bat_dxf_handle(bat_dxf *dxf, int owner);
void bat_dxf_reference(bat_dxf *dxf, int code, int handle);

/* A name as a layer may have: without < > / \ " : ; ? * | = ' and line ends, at most 255 bytes;
 * letters beyond ASCII as \U+XXXX. */
enum { BAT_DXF_NAME = 256 };
void bat_dxf_layer(const char *name, char out[BAT_DXF_NAME]);

/* ---- what must stand around the entities (src/exchange/dxf/write_frame.c) ---- */

typedef struct {
    char name[BAT_DXF_NAME];
    bat_dxf_colour_code colour;
    bool is_off;
} bat_dxf_layer_row;

void bat_dxf_put_colour(bat_dxf *dxf, bat_dxf_colour_code colour);

/* Header, classes, tables and blocks; colours of 24 bits came with release 2004.
 * *model_space is the owner of the entities. */
void bat_dxf_begin(bat_dxf *dxf, double unit_metres, bool has_full_colours, int layer_count,
                   const bat_dxf_layer_row *layers, int handles, int *model_space);
/* The objects, and the end of the file. */
void bat_dxf_end(bat_dxf *dxf);

#endif
