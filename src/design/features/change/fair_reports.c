/* One report of the feature 'fair' for a family of curves: sums, and moves in space. */
#include "design/features/change/fair.h"

static batten_status append_moves(batten_fair_move **all, int *count,
                                  const batten_fair_move *more, int more_count, int set)
{
    if (more_count == 0)
        return BATTEN_OK;
    batten_fair_move *grown = bat_resize(*all, (size_t)(*count + more_count), sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    *all = grown;
    for (int i = 0; i < more_count; i++) {
        grown[*count] = more[i];
        grown[(*count)++].set = set;
    }
    return BATTEN_OK;
}

batten_status bat_fair_add_report(batten_fair_report *sum, const batten_fair_report *one,
                                  int set, int point_count)
{
    batten_fairness_add(&sum->before, &one->before);
    batten_fairness_add(&sum->after, &one->after);
    if (one->max_move > sum->max_move) {
        sum->max_move = one->max_move;
        sum->worst_set = set;
        sum->worst_index = one->worst_index;
    }
    sum->rms_move += one->rms_move * one->rms_move * point_count;
    sum->moved_count += one->moved_count;
    sum->control_points |= one->control_points;
    batten_status status =
        append_moves(&sum->moves, &sum->move_count, one->moves, one->move_count, set);
    if (status == BATTEN_OK)
        status = append_moves(&sum->suspects, &sum->suspect_count, one->suspects,
                              one->suspect_count, set);
    return status;
}

void bat_fair_lift_moves(int axis, double height, batten_fair_move *moves, int count)
{
    for (int i = 0; i < count; i++) {
        const double from[2] = {moves[i].from[0], moves[i].from[1]};
        const double to[2] = {moves[i].to[0], moves[i].to[1]};
        bat_points_from_plane(axis, 1, from, moves[i].from);
        bat_points_from_plane(axis, 1, to, moves[i].to);
        moves[i].from[axis] = moves[i].to[axis] = height;
    }
}
