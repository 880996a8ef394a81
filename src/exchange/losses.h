/* What a file cannot say of the objects that it holds: counted, a message for each kind. */
#ifndef BAT_LOSSES_H
#define BAT_LOSSES_H
#include "exchange/formats.h"

/* The model is as it will be written. Names are a remark: the shapes are as they were. What is
 * hidden and becomes visible in all objects is said where that is done. */
batten_status bat_note_losses(const batten_model *model, const bat_format_row *row,
                              batten_notes *notes);

#endif
