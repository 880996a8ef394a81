/* Rows of points out of tables of offsets, lists of points and curves that have points. */
#include "design/shared/rows.h"
#include "numeric/vector.h"

#include <float.h>
#include <string.h>

static batten_status begin_rows(int count, bat_rows *rows)
{
    rows->rows = bat_array((size_t)count, sizeof *rows->rows);
    rows->count = rows->rows ? count : 0;
    return rows->rows ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static batten_status begin_row(bat_row *row, const char *name, int count)
{
    row->name = name;
    row->points = bat_array3((size_t)count, 3, sizeof *row->points);
    return row->points ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void add_point(bat_row *row, const batten_table_point *p)
{
    double *to = row->points + 3 * row->count++;
    to[0] = p->x;
    to[1] = p->y;
    to[2] = p->z;
}

static batten_status rows_of_stations(const batten_offset_table *table, bat_rows *rows)
{
    batten_status status = begin_rows(batten_offset_table_station_count(table), rows);
    for (int i = 0; i < rows->count && status == BATTEN_OK; i++) {
        const batten_table_station *station = batten_offset_table_station(table, i);
        status = begin_row(&rows->rows[i], station->name, station->point_count);
        for (int k = 0; k < station->point_count && status == BATTEN_OK; k++)
            add_point(&rows->rows[i], &station->points[k]);
    }
    return status;
}

static batten_status rows_of_lines(const batten_offset_table *table, bat_rows *rows)
{
    const int stations = batten_offset_table_station_count(table);
    batten_status status = begin_rows(batten_offset_table_line_count(table), rows);
    int *counts = bat_array((size_t)rows->count, sizeof *counts);
    if (status == BATTEN_OK && !counts)
        status = BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < stations && status == BATTEN_OK; i++) {
        const batten_table_station *station = batten_offset_table_station(table, i);
        for (int k = 0; k < station->point_count; k++)
            if (station->points[k].line >= 0)
                counts[station->points[k].line]++;
    }
    for (int i = 0; i < rows->count && status == BATTEN_OK; i++)
        status = begin_row(&rows->rows[i], batten_offset_table_line(table, i)->name, counts[i]);
    for (int i = 0; i < stations && status == BATTEN_OK; i++) {
        const batten_table_station *station = batten_offset_table_station(table, i);
        for (int k = 0; k < station->point_count; k++)
            if (station->points[k].line >= 0)
                add_point(&rows->rows[station->points[k].line], &station->points[k]);
    }
    bat_release(counts);
    return status;
}

static batten_status row_of_points(const batten_object *object, bat_rows *rows)
{
    batten_status status = begin_rows(1, rows);
    if (status == BATTEN_OK)
        status = begin_row(rows->rows, object->name, object->point_count);
    if (status == BATTEN_OK && object->point_count) {
        memcpy(rows->rows->points, object->points,
               3 * (size_t)object->point_count * sizeof(double));
        rows->rows->count = object->point_count;
    }
    return status;
}

batten_status bat_rows_of(const batten_object *object, bool lines, bat_rows *out)
{
    bat_rows rows = {0, NULL};
    batten_status status;
    if (object->kind != BATTEN_OBJECT_OFFSET_TABLE)
        status = row_of_points(object, &rows);
    else if (lines)
        status = rows_of_lines(object->offset_table, &rows);
    else
        status = rows_of_stations(object->offset_table, &rows);
    if (status == BATTEN_OK)
        *out = rows;
    else
        bat_rows_release(&rows);
    return status;
}

void bat_rows_release(bat_rows *rows)
{
    for (int i = 0; i < rows->count; i++)
        bat_release(rows->rows[i].points);
    bat_release(rows->rows);
    *rows = (bat_rows){0, NULL};
}

/* ---- points in no order ---- */

static batten_status append_row(const bat_row *row, int *count, double **points)
{
    const size_t had = (size_t)*count, more = (size_t)row->count;
    double *grown = bat_resize(*points, 3 * (had + more) + 1, sizeof *grown);
    if (!grown)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(grown + 3 * had, row->points, 3 * more * sizeof *grown);
    *points = grown;
    *count += (int)more;
    return BATTEN_OK;
}

static batten_status add_rows(const batten_object *object, int *count, double **points)
{
    bat_rows rows = {0, NULL};
    batten_status status = bat_rows_of(object, false, &rows);
    for (int i = 0; i < rows.count && status == BATTEN_OK; i++)
        status = append_row(&rows.rows[i], count, points);
    bat_rows_release(&rows);
    return status;
}

batten_status bat_gather_points(const bat_run *run, const char *parameter, int *count,
                                double **points)
{
    bat_objects objects;
    int all = 0;
    double *gathered = NULL;
    batten_status status = bat_gather(run, parameter, BAT_POINTS | BAT_OFFSETS, &objects);
    if (status != BATTEN_OK)
        return status;
    for (int i = 0; i < objects.count && status == BATTEN_OK; i++)
        status = add_rows(objects.at[i], &all, &gathered);
    bat_objects_release(&objects);
    if (status == BATTEN_OK)
        status = bat_points_check_size(all, gathered);
    if (status != BATTEN_OK) {
        bat_release(gathered);
        return status;
    }
    bat_note_reach(run, parameter, all, gathered);
    *count = all;
    *points = gathered;
    return BATTEN_OK;
}

/* ---- plane rows ---- */

int bat_flat_axis(int count, const double *points)
{
    for (int axis = 2; axis >= 0; axis--) {
        int i = 0;
        while (i < count && points[3 * i + axis] == points[axis])
            i++;
        if (i == count)
            return axis;
    }
    return -1;
}

double *bat_points_in_plane(int axis, int count, const double *points)
{
    double *plane = bat_array3((size_t)count, axis < 0 ? 3 : 2, sizeof *plane);
    double *to = plane;
    if (plane && axis < 0 && count > 0)
        memcpy(plane, points, 3 * (size_t)count * sizeof *plane);
    const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    for (const double *from = points; plane && axis >= 0 && to < plane + 2 * (size_t)count;
         from += 3) {
        *to++ = from[first];
        *to++ = from[second];
    }
    return plane;
}

void bat_points_from_plane(int axis, int count, const double *from, double *to)
{
    for (int i = 0; i < 3 * count; i++)
        if (i % 3 != axis)
            to[i] = *from++;
}

batten_status bat_curve_in_plane(const batten_curve *curve, int axis, batten_curve **out)
{
    batten_curve *lifted = NULL, *turned = NULL;
    /* Bring the two coordinates that stay to the front. */
    const int first = axis == 0 ? 1 : 0, second = axis == 2 ? 1 : 2;
    batten_affine map = batten_affine_identity();
    batten_status status = batten_curve_to_dimension(curve, 3, &lifted);
    if (axis < 0 || status != BATTEN_OK) {
        if (status == BATTEN_OK)
            *out = lifted;
        return status;
    }
    memset(map.m, 0, sizeof map.m);
    map.m[0][first] = map.m[1][second] = map.m[2][axis] = 1;
    status = batten_curve_transform(lifted, &map, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(turned, 2, out);
    batten_curve_unref(turned);
    batten_curve_unref(lifted);
    return status;
}

/* @param step  from a point to the next, in points */
static double largest_coordinate(int count, const double *points, size_t step)
{
    double largest = 0;
    for (size_t i = 0; i < (size_t)count; i++)
        for (size_t k = 0; k < 3; k++)
            largest = bat_max(largest, fabs(points[3 * i * step + k]));
    return largest;
}

batten_status bat_points_check_size(int count, const double *points)
{
    /* Cubes of lengths, and their inverses, must neither overflow nor vanish: 1e308 has room for these. */
    static const double least = 1e-90, most = 1e90;
    const double size = largest_coordinate(count, points, 1);
    if (size == 0 || (size >= least && size <= most))
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_ARGUMENT,
                    "the largest coordinate is %g; from %g to %g can be worked with: choose "
                    "another unit",
                    size, least, most);
}

/* ---- what rounding makes of them ---- */

/* Neighbours a millionth as far from each other as others: parameters from distances have no six digits left. */
static const double most_uneven = 1e6;
/* What a method loses to rounding, as a share of the largest coordinate: some ten operations on each. */
static const double lost = 64 * DBL_EPSILON;

bat_spread bat_spread_of(int count, const double *points, size_t step)
{
    /* A power of two by which coordinates are at most some 1, and their squares are numbers; its inverse is one,
     * too. */
    const double largest = largest_coordinate(count, points, step);
    const int exponent = largest > 0 ? bat_max_int(DBL_MIN_EXP, ilogb(largest)) : 0;
    const double scale = ldexp(1, -exponent);
    double least = HUGE_VAL, most = 0; /* squares */
    bat_spread spread = {.largest = largest};
    for (int i = 0; i + 1 < count; i++) {
        const double *from = points + 3 * step * (size_t)i, *to = from + 3 * step;
        const double x = scale * (to[0] - from[0]), y = scale * (to[1] - from[1]),
                     z = scale * (to[2] - from[2]), square = x * x + y * y + z * z;
        most = bat_max(most, square);
        if (square > 0 && square < least) {
            least = square;
            spread.at = i;
        }
    }
    spread.least = sqrt(least) / scale;
    spread.most = sqrt(most) / scale;
    return spread;
}

bool bat_spread_is_uneven(const bat_spread *spread)
{
    return spread->most > most_uneven * spread->least;
}

static void note_size(const bat_run *run, const char *name, double size)
{
    if (lost * size > bat_tolerance(run))
        bat_note(
            run,
            "'%s': coordinates of up to %.3g lose %.2g to rounding, more than the tolerance "
            "%.2g; move the points towards the origin, or ask for less",
            name, size, lost * size, bat_tolerance(run));
}

void bat_note_reach(const bat_run *run, const char *name, int count, const double *points)
{
    note_size(run, name, largest_coordinate(count, points, 1));
}

void bat_note_spacing(const bat_run *run, const char *name, int count, const double *points)
{
    const bat_spread spread = bat_spread_of(count, points, 1);
    if (bat_spread_is_uneven(&spread))
        bat_note(
            run,
            "'%s': points %d and %d are %.3g apart, others up to %.3g; curves through such "
            "points may turn sharply between them: 'thin-points' merges what is meant to be "
            "one",
            name, spread.at + 1, spread.at + 2, spread.least, spread.most);
    note_size(run, name, spread.largest);
}

/* ---- planes wherever they lie ---- */

static batten_vec3 point_of(const double *points, int i)
{
    return (batten_vec3){points[3 * i], points[3 * i + 1], points[3 * i + 2]};
}

/* Off the origin, and off the line along a unit vector where there is one. */
static batten_vec3 offset_of(const double *points, int i, const batten_vec3 *along)
{
    const batten_vec3 off = bat_vec3_subtract(point_of(points, i), point_of(points, 0));
    return along ? bat_vec3_subtract(off, bat_vec3_scale(*along, bat_vec3_dot(off, *along)))
                 : off;
}

/* The longest of these; all are finite. */
static batten_vec3 find_farthest(int count, const double *points, const batten_vec3 *along)
{
    batten_vec3 farthest = {0, 0, 0};
    for (int i = 1; i < count; i++) {
        const batten_vec3 off = offset_of(points, i, along);
        if (bat_vec3_norm(off) > bat_vec3_norm(farthest))
            farthest = off;
    }
    return farthest;
}

static void set_row(batten_affine *map, int row, batten_vec3 way, batten_vec3 origin)
{
    map->m[row][0] = way.x;
    map->m[row][1] = way.y;
    map->m[row][2] = way.z;
    map->t[row] = -bat_vec3_dot(way, origin);
}

bool bat_plane_find(int count, const double *points, batten_affine *to_plane)
{
    double largest = 0;
    for (int i = 0; i < 3 * count; i++)
        largest = bat_max(largest, fabs(points[i]));
    /* Points that were turned into the plane are off it by some roundings of their coordinates. */
    const double rounding = 64 * DBL_EPSILON * largest;
    const batten_vec3 longest = find_farthest(count, points, NULL);
    if (!(bat_vec3_norm(longest) > rounding) || isinf(bat_vec3_norm(longest)))
        return false;
    const batten_vec3 x = bat_vec3_scale(longest, 1 / bat_vec3_norm(longest));
    const batten_vec3 widest = find_farthest(count, points, &x);
    if (!(bat_vec3_norm(widest) > rounding))
        return false;
    const batten_vec3 y = bat_vec3_scale(widest, 1 / bat_vec3_norm(widest));
    const batten_vec3 z = bat_vec3_cross(x, y);
    for (int i = 1; i < count; i++)
        if (fabs(bat_vec3_dot(z, offset_of(points, i, NULL))) > rounding)
            return false;
    *to_plane = batten_affine_identity();
    set_row(to_plane, 0, x, point_of(points, 0));
    set_row(to_plane, 1, y, point_of(points, 0));
    set_row(to_plane, 2, z, point_of(points, 0));
    return true;
}

void bat_plane_points(const batten_affine *to_plane, int count, const double *points,
                      double *plane)
{
    for (int i = 0; i < count; i++) {
        const batten_vec3 at = batten_affine_apply(*to_plane, point_of(points, i));
        plane[2 * i] = at.x;
        plane[2 * i + 1] = at.y;
    }
}

batten_status bat_plane_curve(const batten_affine *to_plane, const batten_curve *curve,
                              batten_curve **out)
{
    batten_curve *turned = NULL;
    batten_status status = batten_curve_transform(curve, to_plane, &turned);
    if (status == BATTEN_OK)
        status = batten_curve_to_dimension(turned, 2, out);
    batten_curve_unref(turned);
    return status;
}
