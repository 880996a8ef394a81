/* Fairing points: the options that are checked for curves and tables alike, the methods, the report. */
#ifndef BAT_FAIR_POINTS_H
#define BAT_FAIR_POINTS_H
#include "fair/one_by_one.h"

batten_status bat_fair_check_options(int count, const batten_fair_options *options);

/* One piece between corners, of four points or more. */
typedef struct {
    const bat_batten *batten;
    bat_ducks ducks;
    const batten_fair_options *options;
    const batten_job *job;
} bat_fair_piece;

/* z [count][width]: at first where the ducks were given, then where a method puts them. */
batten_status bat_fair_springback(const bat_fair_piece *piece, double *z);
batten_status bat_fair_circle_rate(const bat_fair_piece *piece, double *z);
batten_status bat_fair_kjellander(const bat_fair_piece *piece, double *z);
batten_status bat_fair_least_change(const bat_fair_piece *piece, double *z);

/* Has the batten through z, in whose bounds lie the given places, the verdict? */
batten_status bat_piece_is_fair(const bat_fair_piece *piece, const double *z, bool *out);

/* Its points, options and job, for a method that is still to say what it measures. */
bat_one_by_one bat_piece_one_by_one(const bat_fair_piece *piece);

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
