/* What fairing a curve and fairing a table share: the options they check, the report they
 * write. */
#ifndef BAT_SPRINGBACK_H
#define BAT_SPRINGBACK_H
#include "fair/elastic_batten.h"

batten_status bat_fair_check_options(int count, const batten_fair_options *options);

/* A report that grows. Begins with {0}; hand it over with finish, or drop it with end. */
typedef struct {
    batten_fair_report report;
    int move_room, suspect_room;
    int point_count, piece_count;
    double square_sum;
} bat_fair_tally;

/* Fairness before and after of one batten whose first duck is point `first` of the curve `set`,
 * and its blunders. `ducks` has the given places, z the new ones. `functions`: each coordinate
 * is judged as a function of the parameters, instead of all as a curve. */
batten_status bat_tally_piece(bat_fair_tally *tally, const bat_batten *batten,
                              const bat_ducks *ducks, bool functions, int set, int first,
                              const double *z);
/* One point, given and now. */
batten_status bat_tally_point(bat_fair_tally *tally, int width, int set, int index,
                              const double *from, const double *to);
void bat_tally_finish(bat_fair_tally *tally, batten_fair_report *out);
void bat_tally_end(bat_fair_tally *tally);

#endif
