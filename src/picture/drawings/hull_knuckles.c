/* The knuckles of a hull: edges that two surfaces share, and at which its stations turn. */
#include "base/list.h"
#include "picture/drawings/hull.h"

#include "numeric/box.h"
#include "numeric/vector.h"
#include <batten/hull.h>

#include <stdio.h>
#include <string.h>

/* Lines of a drawing are within 1/40,000 of their size; what is four times as near is one line. */
static double near_of(const bat_hull *hull)
{
    return 1e-4 * (hull->high[0] - hull->low[0]);
}

/* A section that turns by less than this, in radians, is taken for round: ten degrees. */
static const double sharp = 10 * BAT_PI / 180;

/* ---- shared edges ---- */

static bool is_near(const double *point, const bat_stroke *line, double near)
{
    for (size_t i = 0; i + 1 < line->count; i++)
        if (bat_segment_distance(3, line->points + 3 * i, line->points + 3 * (i + 1), point) <=
            near)
            return true;
    return false;
}

/* Does the first line run along the second everywhere? */
static bool runs_along(const bat_stroke *line, const bat_stroke *other, double near)
{
    const size_t last = line->count - 1;
    /* The ends and the middle tell most lines apart. */
    if (!is_near(line->points, other, near) || !is_near(line->points + 3 * last, other, near) ||
        !is_near(line->points + 3 * (last / 2), other, near))
        return false;
    for (size_t i = 0; i < line->count; i++)
        if (!is_near(line->points + 3 * i, other, near))
            return false;
    return true;
}

/* Of two edges that are one line the first counts, of a short one along a longer one the short one. */
static bool is_shared(const bat_hull *hull, size_t edge, double near)
{
    const bat_stroke *line = &hull->edges.strokes[edge];
    for (size_t i = 0; i < hull->edges.count; i++) {
        const bat_stroke *other = &hull->edges.strokes[i];
        if (i != edge && runs_along(line, other, near) &&
            (edge < i || !runs_along(other, line, near)))
            return true;
    }
    return false;
}

static bool is_off_centre(const bat_stroke *line, double near)
{
    for (size_t i = 0; i < line->count; i++)
        if (line->points[3 * i + 1] > near)
            return true;
    return false;
}

/* ---- turns ---- */

static bool cross_station(const bat_stroke *line, double x, double margin, double yz[2])
{
    for (size_t i = 0; i + 1 < line->count; i++) {
        const double *p = line->points + 3 * i, *q = p + 3;
        const double from = p[0] - x, to = q[0] - x;
        if (bat_min(from, to) > margin || bat_max(from, to) < -margin || from == to)
            continue;
        const double t = bat_max(0, bat_min(from / (from - to), 1));
        yz[0] = p[1] + t * (q[1] - p[1]);
        yz[1] = p[2] + t * (q[2] - p[2]);
        return true;
    }
    return false;
}

bool bat_knuckle_at(const bat_knuckle *knuckle, double x, double margin, double yz[2])
{
    for (size_t i = 0; i < knuckle->lines.count; i++)
        if (cross_station(&knuckle->lines.strokes[i], x, margin, yz))
            return true;
    return false;
}

/* From one end of a line: the direction towards its first point that is farther than `step`, or its last. */
static void leave_end(const bat_stroke *line, bool last, double step, double way[2])
{
    const double *end = line->points + (last ? 3 * (line->count - 1) : 0);
    for (size_t i = 1; i < line->count; i++) {
        const double *p = line->points + 3 * (last ? line->count - 1 - i : i);
        way[0] = p[1] - end[1];
        way[1] = p[2] - end[2];
        if (bat_hypot(way[0], way[1]) > step)
            return;
    }
}

/* By how much the section turns where two of its lines end at yz; 0 where they do not. */
static double turn_at(const bat_cut *station, const double yz[2], double near, double step)
{
    double ways[2][2];
    int count = 0;
    for (size_t k = 0; k < station->lines.count; k++)
        for (int last = 0; last < 2 && count < 2; last++) {
            const bat_stroke *line = &station->lines.strokes[k];
            const double *end = line->points + (last ? 3 * (line->count - 1) : 0);
            if (bat_hypot(end[1] - yz[0], end[2] - yz[1]) <= near)
                leave_end(line, last, step, ways[count++]);
        }
    if (count < 2)
        return 0;
    return fabs(bat_atan2(ways[0][1] * ways[1][0] - ways[0][0] * ways[1][1],
                          -(ways[0][0] * ways[1][0] + ways[0][1] * ways[1][1])));
}

/* An edge that crosses two stations at least, and at which one of them turns. */
static bool is_knuckle(const bat_hull *hull, const bat_stroke *line)
{
    const bat_cuts *stations = &hull->families[BAT_STATIONS];
    const double near = near_of(hull), step = 0.01 * (hull->high[2] - hull->low[2]);
    double turn = 0, yz[2];
    int crossed = 0;
    for (int i = 0; i < stations->count; i++)
        if (cross_station(line, stations->cuts[i].at, 0, yz)) {
            crossed++;
            turn = bat_max(turn, turn_at(&stations->cuts[i], yz, 2 * near, step));
        }
    return crossed >= 2 && turn >= sharp;
}

/* ---- lines of several pieces ---- */

static double reach(const bat_stroke *line, double sign)
{
    double most = -HUGE_VAL;
    for (size_t i = 0; i < line->count; i++)
        most = bat_max(most, sign * line->points[3 * i]);
    return sign * most;
}

static bool ends_meet(const bat_stroke *a, const bat_stroke *b, double near)
{
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2; k++)
            if (bat_distance(3, a->points + 3 * (i ? a->count - 1 : 0),
                             b->points + 3 * (k ? b->count - 1 : 0)) <= near)
                return true;
    return false;
}

/* Does the line go on where a piece of the knuckle ends? */
static bool goes_on(const bat_knuckle *knuckle, const bat_stroke *line, double near)
{
    bool meets = false;
    for (size_t i = 0; i < knuckle->lines.count; i++) {
        const bat_stroke *piece = &knuckle->lines.strokes[i];
        if (reach(line, 1) > reach(piece, -1) + near &&
            reach(piece, 1) > reach(line, -1) + near)
            return false; /* beside it */
        meets |= ends_meet(piece, line, near);
    }
    return meets;
}

static batten_status keep_piece(const bat_stroke *line, bat_knuckle *knuckle)
{
    double *points = bat_array3(line->count, 3, sizeof *points);
    if (!points)
        return BATTEN_OUT_OF_MEMORY;
    memcpy(points, line->points, 3 * line->count * sizeof *points);
    return bat_strokes_add(&knuckle->lines, (bat_stroke){line->count, points});
}

static batten_status keep_line(bat_hull *hull, const bat_stroke *line)
{
    for (int i = 0; i < hull->knuckle_count; i++)
        if (goes_on(&hull->knuckles[i], line, near_of(hull)))
            return keep_piece(line, &hull->knuckles[i]);
    const batten_status status = BAT_LIST_ADD(hull->knuckles, hull->knuckle_count,
                                              hull->knuckle_room, (bat_knuckle){.name = ""});
    return status == BATTEN_OK ? keep_piece(line, &hull->knuckles[hull->knuckle_count - 1])
                               : status;
}

/* ---- order and names ---- */

static double foot_of(const bat_knuckle *knuckle)
{
    double foot = HUGE_VAL;
    for (size_t i = 0; i < knuckle->lines.count; i++)
        for (size_t k = 0; k < knuckle->lines.strokes[i].count; k++)
            foot = bat_min(foot, knuckle->lines.strokes[i].points[3 * k + 2]);
    return foot;
}

static void sort_knuckles(bat_hull *hull)
{
    for (int i = 1; i < hull->knuckle_count; i++)
        for (int k = i; k > 0 && foot_of(&hull->knuckles[k]) < foot_of(&hull->knuckles[k - 1]);
             k--) {
            const bat_knuckle lower = hull->knuckles[k];
            hull->knuckles[k] = hull->knuckles[k - 1];
            hull->knuckles[k - 1] = lower;
        }
}

/* Are the points of this line of a table on the knuckle, to a hundredth of the half-breadth? */
static bool is_line_of(const batten_offset_table *table, int line, const bat_hull *hull,
                       const bat_knuckle *knuckle)
{
    const double near = 0.01 * hull->high[1];
    int found = 0;
    for (int i = 0; i < batten_offset_table_station_count(table); i++) {
        const batten_table_station *station = batten_offset_table_station(table, i);
        for (int k = 0; k < station->point_count; k++) {
            const batten_table_point *p = &station->points[k];
            double yz[2];
            if (p->line != line || !bat_knuckle_at(knuckle, p->x, near_of(hull), yz))
                continue;
            if (bat_hypot(fabs(p->y) - yz[0], p->z - yz[1]) > near)
                return false;
            found++;
        }
    }
    return found >= 2;
}

static void take_name(const batten_model *data, const bat_hull *hull, bat_knuckle *knuckle)
{
    for (int i = 0; data && i < batten_model_count(data); i++) {
        const batten_object *object = batten_model_object(data, i);
        if (object->kind != BATTEN_OBJECT_OFFSET_TABLE)
            continue;
        for (int k = 0; k < batten_offset_table_line_count(object->offset_table); k++)
            if (is_line_of(object->offset_table, k, hull, knuckle)) {
                snprintf(knuckle->name, sizeof knuckle->name, "%s",
                         batten_offset_table_line(object->offset_table, k)->name);
                return;
            }
    }
}

batten_status bat_hull_find_knuckles(const batten_model *data, bat_hull *hull)
{
    const double near = near_of(hull);
    batten_status status = BATTEN_OK;
    for (size_t i = 0; i < hull->edges.count && status == BATTEN_OK; i++) {
        const bat_stroke *line = &hull->edges.strokes[i];
        if (is_off_centre(line, near) && is_shared(hull, i, near) && is_knuckle(hull, line))
            status = keep_line(hull, line);
    }
    sort_knuckles(hull);
    for (int i = 0; i < hull->knuckle_count; i++) {
        snprintf(hull->knuckles[i].name, sizeof hull->knuckles[i].name, "knuckle %d", i + 1);
        take_name(data, hull, &hull->knuckles[i]);
    }
    return status;
}
