/* The readers and writers of text in rows and columns. */
#ifndef BAT_CSV_H
#define BAT_CSV_H
#include "exchange/csv/gather.h"
#include "exchange/csv/separated.h"
#include <batten/exchange.h>
#include <batten/text.h>

batten_status bat_read_offsets(bat_input *input, batten_model **out);
batten_status bat_read_points(bat_input *input, batten_model **out);
batten_status bat_read_aerofoil(bat_input *input, batten_model **out);

/* The dialects of a table of offsets. The table stands on its first row. */
typedef enum {
    BAT_OFFSETS_NONE,
    BAT_OFFSETS_LONG,   /* a header that names x, z and y; then a row for each point */
    BAT_OFFSETS_MATRIX, /* stations against heights; the corner cell says which is which */
    BAT_OFFSETS_LOFT,   /* the boat builder's: axis, name, stations; lengths, heights, widths */
    BAT_OFFSETS_LOFTING /* the loftsman's: stations; positions, heights, breadths, diagonals */
} bat_offsets_dialect;
/* "station\\height": does the text say what the rows and columns of a matrix are? */
bool bat_is_matrix_corner(const char *text);
/* Is it a table of offsets for sure? Where columns are named by letters alone, one must be of
 * hulls: station, half-breadth, waterline, line or section. */
bool bat_is_offsets_header(const bat_separated *table);
/* Does the first row name columns x and y of points, perhaps z, and others that are none? */
bool bat_is_points_header(const bat_separated *table);

batten_status bat_offsets_long(bat_separated *table, bat_gathering *gathering);
batten_status bat_offsets_matrix(bat_separated *table, bat_gathering *gathering);
batten_status bat_offsets_loft(bat_separated *table, bat_gathering *gathering);
batten_status bat_offsets_lofting(bat_separated *table, bat_gathering *gathering);

/* Is the text, which begins with a number, a table of frames that comes out even? Cost: reads it all. */
batten_status bat_are_frames(const bat_input *input, bool *are_frames);
batten_status bat_offsets_frames(bat_input *input, bat_gathering *gathering);

/* Do the first two rows of an aerofoil begin with Lednicer's counts? */
bool bat_are_aerofoil_counts(const double first[3], const double second[3]);

batten_status bat_write_offsets(const batten_model *model, const batten_write_options *options,
                                batten_notes *notes, batten_text *text);
/* In feet, inches and eighths, lines by stations; for options->eighths. */
batten_status bat_write_loft(const batten_object *object, double unit_metres,
                             batten_notes *notes, batten_text *text);
batten_status bat_write_points(const batten_model *model, const batten_write_options *options,
                               batten_notes *notes, batten_text *text);
batten_status bat_write_aerofoil(const batten_model *model, const batten_write_options *options,
                                 batten_notes *notes, batten_text *text);

#endif
