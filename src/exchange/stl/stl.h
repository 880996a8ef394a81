/* STL: triangles without sharing, as text or as bytes. It has no units. */
#ifndef BAT_STL_H
#define BAT_STL_H
#include "exchange/reading/input.h"
#include "exchange/reading/scan.h"
#include <batten/exchange.h>
#include <batten/text.h>

/* By the words at the beginning, by the size that the count at byte 80 asks for, or, when bytes
 * are missing or follow, by the file's name. */
batten_status bat_stl_recognise(const bat_input *input, bool *is_such);
/* An object for each solid; corners at the same point are one vertex. */
batten_status bat_read_stl(bat_input *input, batten_model **out);
batten_status bat_write_stl(const batten_model *model, const batten_write_options *options,
                            batten_notes *notes, batten_text *text);

/* ---- between the two forms ---- */

/* One solid while it is read: its corners, three for each triangle. */
typedef struct {
    bat_input *input;
    bat_list points; /* of double[9] */
    int against;     /* triangles whose normal says that they are turned the other way */
} bat_stl_solid;

/* One more triangle; one with a corner that is no number is left out with a note. */
batten_status bat_stl_add(bat_stl_solid *solid, int line, size_t index, const double corners[9],
                          const double normal[3]);
/* The solid as an object of the model, if it has triangles; it is then empty. */
batten_status bat_stl_end(bat_stl_solid *solid, const char *name, batten_model *model);

batten_status bat_stl_read_text(bat_input *input, batten_model *model);

/* The name after "solid" or "endsolid": the rest of the line, or what stands before the first
 * triangle when the whole file is one line. */
bat_span bat_stl_name(bat_scan *words);

#endif
