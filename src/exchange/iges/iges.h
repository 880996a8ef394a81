/* Reading and writing IGES 5.3. */
#ifndef BAT_IGES_H
#define BAT_IGES_H
#include "exchange/reading/input.h"
#include <batten/text.h>

/* Is it an IGES file? UNSUPPORTED for the compressed and the binary form. */
batten_status bat_iges_recognise(const bat_input *input, bool *is_iges);
batten_status bat_read_iges(bat_input *input, batten_model **out);
/* Is it a motion, a mirroring or a scaling, so that reading gives back its bits? */
bool bat_iges_can_place(const batten_affine *place);
batten_status bat_write_iges(const batten_model *model, const batten_write_options *options,
                             batten_notes *notes, batten_text *text);

/* The flag of a unit in the global section, 2 for mm; 3 when the unit has none. */
int bat_iges_flag_of_unit(double metres);

#endif
