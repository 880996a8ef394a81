/* A piece between corners, as the methods that move its points one by one see it: what they may do, and when they are done. */
#include "fair/fair_points.h"
#include "fair/fairness.h"

batten_status bat_piece_is_fair(const bat_fair_piece *piece, const double *z, bool *out)
{
    const bat_ducks *ducks = &piece->ducks;
    return bat_batten_is_fair(
        piece->batten, &(bat_batten_points){ducks->width, ducks->centre, ducks->within, z},
        out);
}

static batten_status is_fair(const void *piece, const double *z, bool *done)
{
    return bat_piece_is_fair(piece, z, done);
}

bat_one_by_one bat_piece_one_by_one(const bat_fair_piece *piece)
{
    return (bat_one_by_one){.is_done = piece->options->stop_when_fair ? is_fair : NULL,
                            .judge = piece,
                            .count = piece->batten->count,
                            .ducks = &piece->ducks,
                            .most = piece->options->max_moves,
                            .job = piece->job};
}
