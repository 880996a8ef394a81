/* The points of an aerofoil in one order, without those that are not its sides. */
#include "numeric/vector.h"
#include "shape/aerofoil/aerofoil.h"
#include "spline/data_check.h"

#include <string.h>

/* Nearer than this part of the size, points are the same: files have seven digits at most. */
static const double same = 1e-9;

void bat_aerofoil_reverse(bat_aerofoil_row *row, int count)
{
    for (int i = 0, k = count - 1; i < k; i++, k--) {
        double kept[2];
        const int index = row->index[i];
        memcpy(kept, row->points[i], sizeof kept);
        memcpy(row->points[i], row->points[k], sizeof kept);
        memcpy(row->points[k], kept, sizeof kept);
        row->index[i] = row->index[k];
        row->index[k] = index;
    }
}

static double distance_of(const bat_aerofoil_row *row, int i, int k)
{
    return bat_distance(2, row->points[i], row->points[k]);
}

static double find_size(const bat_aerofoil_row *row)
{
    double size = 0;
    for (int i = 1; i < row->count; i++)
        size = bat_max(size, distance_of(row, 0, i));
    return size;
}

/* Lednicer's halves both run from the nose: one step leads from the tail back to it. */
static batten_status join_halves(bat_aerofoil_row *row, double size,
                                 batten_curve_aerofoil_report *report)
{
    const int last = row->count - 1;
    int upper = 0;
    if (distance_of(row, 0, last) <= size / 2)
        return BATTEN_OK;
    for (int i = 1; i < last && !upper; i++)
        if (distance_of(row, i, i + 1) > size / 2 && distance_of(row, 0, i + 1) < size / 4)
            upper = i + 1;
    if (!upper)
        return bat_fail(BATTEN_NOT_COMPATIBLE,
                        "the points begin at (%g, %g) and end at (%g, %g), which are not both "
                        "at the trailing edge",
                        row->points[0][0], row->points[0][1], row->points[last][0],
                        row->points[last][1]);
    bat_aerofoil_reverse(row, upper);
    report->halves = true;
    return BATTEN_OK;
}

static void drop_repeated(bat_aerofoil_row *row, double size,
                          batten_curve_aerofoil_report *report)
{
    int kept = 1;
    for (int i = 1; i < row->count; i++) {
        if (distance_of(row, kept - 1, i) <= same * size) {
            report->repeated++;
            continue;
        }
        memmove(row->points[kept], row->points[i], sizeof row->points[i]);
        row->index[kept++] = row->index[i];
    }
    row->count = kept;
}

/* Is the step between two points more across the chord than along it? */
static bool is_across(const bat_aerofoil_row *row, const double chord[2], int from, int to)
{
    const double *p = row->points[from], *q = row->points[to];
    const double along = (q[0] - p[0]) * chord[0] + (q[1] - p[1]) * chord[1];
    const double across = (q[1] - p[1]) * chord[0] - (q[0] - p[0]) * chord[1];
    return fabs(across) > fabs(along);
}

static int find_farthest(const bat_aerofoil_row *row)
{
    int far = 0;
    for (int i = 1; i < row->count; i++)
        if (distance_of(row, 0, i) > distance_of(row, 0, far))
            far = i;
    return far;
}

/* From the nose, which is about there, to an end. */
static void find_chord(const bat_aerofoil_row *row, int nose, double chord[2])
{
    for (int k = 0; k < 2; k++)
        chord[k] = row->points[0][k] - row->points[nose][k];
}

/*
 * Ends that are apart along the chord are no two corners of a trailing edge: one of them is its
 * point, and is not repeated at the other end. There is room for one point more.
 */
static void close_ring(bat_aerofoil_row *row, batten_curve_aerofoil_report *report)
{
    const int nose = find_farthest(row), last = row->count - 1;
    double chord[2];
    find_chord(row, nose, chord);
    if (distance_of(row, 0, last) == 0 || is_across(row, chord, 0, last))
        return;
    report->closed = true;
    const bool is_first = distance_of(row, nose, 0) >= distance_of(row, nose, last);
    if (!is_first) {
        memmove(row->points + 1, row->points, (size_t)row->count * sizeof *row->points);
        memmove(row->index + 1, row->index, (size_t)row->count * sizeof *row->index);
    }
    row->count++;
    const int from = is_first ? 0 : row->count - 1, to = is_first ? row->count - 1 : 0;
    memcpy(row->points[to], row->points[from], sizeof row->points[to]);
    row->index[to] = row->index[from];
}

/* Rows that end where they begin may contain the base, which stands across the chord. */
static void drop_base(bat_aerofoil_row *row, double size, batten_curve_aerofoil_report *report)
{
    int first = 0, last = row->count - 1;
    double chord[2];
    if (distance_of(row, 0, last) > same * size)
        return;
    const int far = find_farthest(row);
    find_chord(row, far, chord);
    while (first < far && is_across(row, chord, first, first + 1))
        first++;
    while (last > far && is_across(row, chord, last, last - 1))
        last--;
    report->base = first + row->count - 1 - last;
    row->count = last - first + 1;
    memmove(row->points, row->points + first, (size_t)row->count * sizeof *row->points);
    memmove(row->index, row->index + first, (size_t)row->count * sizeof *row->index);
}

static batten_status check_count(const bat_aerofoil_row *row)
{
    enum { LEAST = 5 }; /* both ends, the nose, and one point of each side */
    if (row->count >= LEAST)
        return BATTEN_OK;
    return bat_fail(BATTEN_TOO_FEW_POINTS,
                    "an aerofoil needs at least %d different points, not %d", LEAST,
                    row->count);
}

batten_status bat_aerofoil_take(batten_points points, bat_aerofoil_row *row,
                                batten_curve_aerofoil_report *report)
{
    batten_status status = points.dimension == 2
                               ? bat_points_check(2, points.count, points.at, 1)
                               : bat_wrong_dimension(points, 2);
    if (status != BATTEN_OK)
        return status;
    const size_t count = (size_t)points.count, room = count + 1;
    row->points = bat_array(room, sizeof *row->points);
    row->index = bat_array(room, sizeof *row->index);
    row->at = bat_array(room, sizeof *row->at);
    if (!row->points || !row->index || !row->at)
        return BATTEN_OUT_OF_MEMORY;
    row->count = points.count;
    memcpy(row->points, points.at, count * sizeof *row->points);
    for (int i = 0; i < row->count; i++)
        row->index[i] = i;
    const double size = find_size(row);
    status = join_halves(row, size, report);
    if (status != BATTEN_OK)
        return status;
    drop_repeated(row, size, report);
    status = check_count(row);
    if (status == BATTEN_OK) {
        close_ring(row, report);
        drop_base(row, size, report);
    }
    return status == BATTEN_OK ? check_count(row) : status;
}

void bat_aerofoil_row_release(bat_aerofoil_row *row)
{
    bat_release(row->points);
    bat_release(row->index);
    bat_release(row->at);
}
