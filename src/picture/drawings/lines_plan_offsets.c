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

/* The value of one coordinate where another has the value `at`: the largest, or the least. */
typedef struct {
    int of, where; /* coordinates */
    double at;
    bool largest;
    double value; /* NaN until one is found */
} crossing;

static void take_value(crossing *c, double value)
{
    if (isnan(c->value) || (c->largest ? value > c->value : value < c->value))
        c->value = value;
}

static void find_crossing(void *user, const bat_stroke *line)
{
    crossing *c = user;
    for (size_t i = 0; i + 1 < line->count; i++) {
        const double *p = line->points + 3 * i, *q = p + 3;
        const double from = p[c->where] - c->at, to = q[c->where] - c->at;
        if (from == 0)
            take_value(c, p[c->of]);
        if (to == 0)
            take_value(c, q[c->of]);
        if ((from < 0) != (to < 0) && from != to)
            take_value(c, p[c->of] + (q[c->of] - p[c->of]) * (from / (from - to)));
    }
}

double bat_lines_offset(const bat_lines_sheet *s, int station, bat_family family, int line)
{
    crossing c = {.of = family == BAT_WATERLINES ? 1 : 2,
                  .where = family == BAT_WATERLINES ? 2 : 1,
                  .at = s->hull.families[family].cuts[line].at,
                  .largest = family == BAT_WATERLINES,
                  .value = (double)NAN};
    visit_station(s, station, find_crossing, &c);
    return c.value;
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
