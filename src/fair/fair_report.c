/* The report of fairing: points that moved, by how much, fairness before and after, suspects. */
#include "base/list.h"
#include "fair/fair_points.h"
#include "fair/fairness.h"
#include "numeric/select.h"

#include <float.h>
#include <string.h>

static batten_fair_move move_of(int width, int set, int index, const double *from,
                                const double *to)
{
    batten_fair_move move = {.set = set, .index = index};
    memcpy(move.from, from, (size_t)width * sizeof *from);
    memcpy(move.to, to, (size_t)width * sizeof *to);
    return move;
}

batten_status bat_tally_point(bat_fair_tally *tally, int width, int set, int index,
                              const double *from, const double *to)
{
    batten_fair_report *report = &tally->report;
    const double moved = bat_distance(width, from, to);
    if (moved == 0) {
        tally->point_count++;
        return BATTEN_OK;
    }
    const batten_fair_move move = move_of(width, set, index, from, to);
    batten_status status =
        BAT_LIST_ADD(report->moves, report->move_count, tally->move_room, move);
    if (status != BATTEN_OK)
        return status;
    tally->point_count++;
    report->moved_count = report->move_count;
    tally->square_sum += moved * moved;
    if (moved > report->max_move) {
        report->max_move = moved;
        report->worst_set = set;
        report->worst_index = index;
    }
    return BATTEN_OK;
}

/* ---- blunders ---- */

/* A force as large as a wrong number makes: a peak between neighbours that push the other way.
 */
static bool is_peak(int width, const double *forces, const double *sizes, int i,
                    double threshold)
{
    double before = 0, after = 0;
    const double *force = forces + i * width;
    for (int k = 0; k < width; k++) {
        before += force[k] * force[k - width];
        after += force[k] * force[k + width];
    }
    return sizes[i] > threshold && sizes[i] > sizes[i - 1] && sizes[i] > sizes[i + 1] &&
           before < 0 && after < 0;
}

static batten_status suspect(bat_fair_tally *tally, const bat_batten *batten, int width,
                             const double *points, const double *force, int set, int first,
                             int i)
{
    double to[3];
    for (int k = 0; k < width; k++)
        to[k] = points[i * width + k] - force[k] / batten->diagonal[i];
    const batten_fair_move move = move_of(width, set, first + i, points + i * width, to);
    return BAT_LIST_ADD(tally->report.suspects, tally->report.suspect_count,
                        tally->suspect_room, move);
}

/* `work` [count][2 width + 2]. Forces of roundoff are no sign of anything. */
static batten_status find_suspects(bat_fair_tally *tally, const bat_batten *batten, int width,
                                   const double *points, int set, int first, double *work)
{
    const int n = batten->count;
    const double zero[3] = {0};
    double *forces = work + n * width, *sizes = forces + n * width, *sorted = sizes + n;
    double size = 0;
    bat_batten_bend(batten, width, points, work, forces);
    for (int i = 0; i < n; i++) {
        sorted[i] = sizes[i] = bat_distance(width, forces + i * width, zero);
        size = bat_max(size, bat_distance(width, points + i * width, zero));
    }
    const double median = bat_select((size_t)n, sorted, (size_t)n / 2);
    batten_status status = BATTEN_OK;
    for (int i = 1; status == BATTEN_OK && i < n - 1; i++) {
        const double roundoff = 64 * DBL_EPSILON * size * batten->diagonal[i];
        if (is_peak(width, forces, sizes, i, bat_max(6 * median, roundoff)))
            status = suspect(tally, batten, width, points, forces + i * width, set, first, i);
    }
    return status;
}

/* ---- pieces ---- */

static batten_status judge_batten(bat_fair_tally *tally, const bat_batten *batten,
                                  const bat_batten_points *faired)
{
    bat_batten_points given = *faired;
    given.z = given.points;
    batten_fairness before, after;
    batten_status status = bat_batten_fairness(batten, &given, &before);
    if (status == BATTEN_OK)
        status = bat_batten_fairness(batten, faired, &after);
    if (status != BATTEN_OK)
        return status;
    if (tally->piece_count++ == 0)
        tally->report.before.fair = tally->report.after.fair = true;
    batten_fairness_add(&tally->report.before, &before);
    batten_fairness_add(&tally->report.after, &after);
    return BATTEN_OK;
}

/* Each coordinate by itself, a function over the parameters. */
static batten_status judge_functions(bat_fair_tally *tally, const bat_batten *batten,
                                     const bat_ducks *ducks, const double *z)
{
    const int n = batten->count, width = ducks->width;
    double *columns = bat_array3((size_t)n, 2, sizeof *columns);
    batten_status status = columns ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int k = 0; status == BATTEN_OK && k < width; k++) {
        for (int i = 0; i < n; i++) {
            columns[i] = ducks->centre[i * width + k];
            columns[n + i] = z[i * width + k];
        }
        status = judge_batten(tally, batten,
                              &(bat_batten_points){1, columns, ducks->within, columns + n});
    }
    bat_release(columns);
    return status;
}

batten_status bat_tally_piece(bat_fair_tally *tally, const bat_batten *batten,
                              const bat_ducks *ducks, bool functions, int set, int first,
                              const double *z)
{
    const int width = ducks->width;
    const bat_batten_points all = {width, ducks->centre, ducks->within, z};
    batten_status status = functions ? judge_functions(tally, batten, ducks, z)
                                     : judge_batten(tally, batten, &all);
    if (status != BATTEN_OK || batten->count < 5) /* too few for a median to mean something */
        return status;
    double *work = bat_array3((size_t)batten->count, 2 * (size_t)width + 2, sizeof *work);
    if (!work)
        return BATTEN_OUT_OF_MEMORY;
    status = find_suspects(tally, batten, width, ducks->centre, set, first, work);
    bat_release(work);
    return status;
}

void bat_tally_finish(bat_fair_tally *tally, batten_fair_report *out)
{
    if (tally->point_count > 0)
        tally->report.rms_move = sqrt(tally->square_sum / tally->point_count);
    *out = tally->report;
    *tally = (bat_fair_tally){0};
}

void bat_tally_end(bat_fair_tally *tally)
{
    batten_fair_report_release(&tally->report);
}

void batten_fair_report_release(batten_fair_report *report)
{
    bat_release(report->moves);
    bat_release(report->suspects);
    *report = (batten_fair_report){0};
}
