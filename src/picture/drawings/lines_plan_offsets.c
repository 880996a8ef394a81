/* What the lines of a hull measure at a station: its offsets. */
#include "picture/drawings/lines_plan.h"

/* Does the line lie in the plane of the station? Edges at the very ends do; there no section is cut. */
static bool is_in_plane(const bat_stroke *line, double at, double margin)
{
    for (size_t i = 0; i < line->count; i++)
        if (fabs(line->points[3 * i] - at) > margin)
            return false;
    return true;
}

typedef void see_line(void *user, const bat_stroke *line);

/* The lines of the hull at a station. */
static void visit_station(const bat_lines_sheet *s, int station, see_line *see, void *user)
{
    const bat_cut *cut = &s->hull.families[BAT_STATIONS].cuts[station];
    const double margin = 1e-6 * (s->hull.high[0] - s->hull.low[0]);
    for (size_t i = 0; i < cut->lines.count; i++)
        see(user, &cut->lines.strokes[i]);
    for (size_t i = 0; cut->lines.count == 0 && i < s->hull.edges.count; i++)
        if (is_in_plane(&s->hull.edges.strokes[i], cut->at, margin))
            see(user, &s->hull.edges.strokes[i]);
}

/* What is measured where a line meets a plane: of all values the largest, or the least. */
typedef struct {
    bat_family family;
    const bat_cut *plane;
    double value; /* NaN until one is found */
} crossing;

/* On which side of the plane a point is, and what is measured there. */
static double side_of(const crossing *c, const double *point)
{
    if (c->family == BAT_DIAGONALS)
        return point[1] * bat_sin(c->plane->angle) +
               (point[2] - c->plane->at) * bat_cos(c->plane->angle);
    return point[c->family] - c->plane->at;
}

static double measure_point(const crossing *c, const double *point)
{
    if (c->family == BAT_DIAGONALS)
        return bat_diagonal_way(c->plane, point);
    return point[c->family == BAT_WATERLINES ? 1 : 2];
}

static void take_value(crossing *c, double value)
{
    const bool is_least = c->family == BAT_BUTTOCKS;
    if (isnan(c->value) || (is_least ? value < c->value : value > c->value))
        c->value = value;
}

static void find_crossing(void *user, const bat_stroke *line)
{
    crossing *c = user;
    for (size_t i = 0; i + 1 < line->count; i++) {
        const double *p = line->points + 3 * i, *q = p + 3;
        const double from = side_of(c, p), to = side_of(c, q);
        const double first = measure_point(c, p), second = measure_point(c, q);
        if (from == 0)
            take_value(c, first);
        if (to == 0)
            take_value(c, second);
        if ((from < 0) != (to < 0) && from != to)
            take_value(c, first + (second - first) * (from / (from - to)));
    }
}

double bat_lines_offset(const bat_lines_sheet *s, int station, bat_family family, int line)
{
    crossing c = {
        .family = family, .plane = &s->hull.families[family].cuts[line], .value = (double)NAN};
    visit_station(s, station, find_crossing, &c);
    return c.value;
}

void bat_lines_knuckle_offsets(const bat_lines_sheet *s, int station, int knuckle, double yz[2])
{
    /* A station at the end of the knuckle, but for rounding, has it. */
    const double margin = 1e-6 * (s->hull.high[0] - s->hull.low[0]);
    if (!bat_knuckle_at(&s->hull.knuckles[knuckle],
                        s->hull.families[BAT_STATIONS].cuts[station].at, margin, yz))
        yz[0] = yz[1] = (double)NAN;
}

static void find_ends(void *user, const bat_stroke *line)
{
    bat_lines_ends *e = user;
    for (size_t i = 0; i < line->count; i++) {
        const double *p = line->points + 3 * i;
        if (isnan(e->keel) || p[2] < e->keel)
            e->keel = p[2];
        if (isnan(e->sheer) || p[2] > e->sheer)
            e->sheer = p[2], e->breadth = p[1];
    }
}

bat_lines_ends bat_lines_ends_of(const bat_lines_sheet *s, int station)
{
    const double none = (double)NAN;
    bat_lines_ends e = {none, none, none};
    visit_station(s, station, find_ends, &e);
    return e;
}
