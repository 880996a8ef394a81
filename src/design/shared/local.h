/* What the features of local interpolation share. */
#ifndef BAT_DESIGN_LOCAL_H
#define BAT_DESIGN_LOCAL_H
#include "design/shared/through.h"
#include <batten/local.h>

/* The words of batten_tangent_rule, in its order, without GIVEN. */
#define BAT_TANGENT_WORDS "circle bessel akima renner parabola bisector"

#define BAT_PHANTOMS                                                                        \
    {                                                                                       \
        "beyond", BATTEN_VALUE_WORD, false, false, "extrapolate",                           \
            "extrapolate reflect repeat",                                                   \
            "points beyond an end: on a polynomial, mirrored in the end, or the end itself" \
    }
#define BAT_CHORD_POWER(usual)                                                     \
    {                                                                              \
        "alpha", BATTEN_VALUE_NUMBER, false, false, usual, NULL,                   \
            "steps are chords to this power: 0 uniform, 0.5 centripetal, 1 chords" \
    }

/* The cubic with tangents by a rule and a length; `closed` says whether the row closes. */
batten_status bat_make_of_tangents(bat_run *run, const bat_data *data,
                                   const batten_tangents_options *options, bat_made *made);
/* The cubic function with slopes by a rule. */
batten_status bat_make_of_slopes(const bat_data *data, batten_slope_rule rule, bat_made *made);
/* Of a function the one, of a curve the other, closed or not as the run says. */
batten_status bat_make_local(bat_run *run, const bat_data *data, batten_slope_rule slopes,
                             batten_tangent_rule tangents, batten_tangent_length length,
                             bat_made *made);
/* The cubic with the tangents of Kochanek and Bartels: 'alpha', 'beyond' and 'closed' are
 * taken from the run, the rest from the options. */
batten_status bat_make_kochanek_bartels(bat_run *run, const bat_data *data,
                                        batten_tangents_kochanek_bartels_options *options,
                                        bat_made *made);
/* Say where the polygon turned back. */
void bat_note_turns(bat_run *run, const bat_data *data, const batten_tangents_report *report);

/* The vectors of a list that has one for each point, [count][dimension] in the plane of the
 * data or in space; NULL when the list was not given. Release them. */
batten_status bat_vectors(const bat_run *run, const bat_data *data, const char *parameter,
                          double **out);
#endif
