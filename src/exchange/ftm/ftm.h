/*
 * The text form of FREE!ship's models, .ftm: settings of the project, layers, then the control
 * net of a subdivision surface: points, edges, curves and faces, a number or a row of them to a
 * line. Settings differ from version to version and are not read.
 */
#ifndef BAT_FTM_H
#define BAT_FTM_H
#include "exchange/reading/input.h"

batten_status bat_ftm_recognise(const bat_input *input, bool *is_ftm);
/* The faces of each layer as a mesh: the control net itself, not the surface it stands for. */
batten_status bat_read_ftm(bat_input *input, batten_model **out);

#endif
