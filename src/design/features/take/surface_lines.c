/* The feature 'surface-lines': lines of curvature, asymptotic lines and geodesics. */
#include "design/features/take/contour_curves.h"

#include <batten/nearest.h>
#include <stdio.h>

/* The words of 'kind' name each line of batten_line_kind in its order, then pairs of them. */
#define KINDS "curvature1 curvature2 asymptotic1 asymptotic2 geodesic curvature asymptotic"
enum { BOTH_CURVATURES = BATTEN_LINE_GEODESIC + 1, BOTH_ASYMPTOTICS };

static const batten_parameter parameters[] = {
    {"surface-lines", BATTEN_VALUE_MODEL, true, true, NULL, NULL, "surfaces"},
    {"through", BATTEN_VALUE_POINT, true, true, NULL, NULL,
     "where lines start: the nearest points of the surface nearest to each"},
    {"kind", BATTEN_VALUE_WORD, false, false, "curvature", KINDS,
     "1: along the direction of the larger curvature, or left of it; 2: of the smaller, or right"},
    {"direction", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "of geodesics, laid into the tangent plane; of several each starts at each point"},
    {"length", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "at which a line ends on each side of its start; ten times the size of the surface by default"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how close the curves are to the lines; the tolerance of the design by default"},
};

typedef struct {
    bat_run *run;
    bat_objects surfaces;
    double within, error;
} search;

/* ---- where a line starts ---- */

typedef struct {
    int surface;
    double uv[2], distance;
} foot;

static const batten_object *object_at(const search *s, const foot *f)
{
    return s->surfaces.at[f->surface];
}

static batten_status find_foot(const search *s, const double *point, foot *out)
{
    foot best = {.distance = HUGE_VAL};
    for (int i = 0; i < s->surfaces.count; i++) {
        foot f = {.surface = i};
        batten_deviation deviation;
        const batten_status status = batten_surface_project(
            s->surfaces.at[i]->surface, (batten_points){3, 1, point}, NULL, s->run->job,
            (batten_feet){f.uv, &f.distance}, &deviation);
        if (status != BATTEN_OK)
            return status;
        if (f.distance < best.distance)
            best = f;
    }
    *out = best;
    return BATTEN_OK;
}

/* ---- what is said of a line ---- */

static const char *name_of(batten_line_kind kind, int number, char *name, size_t size)
{
    static const char *const names[] = {"curvature1", "curvature2", "asymptotic1",
                                        "asymptotic2", "geodesic"};
    snprintf(name, size, "%s %d", names[kind], number);
    return name;
}

static void tell_line(const search *s, const char *name, const batten_surface_line *line,
                      bool goes_one_way)
{
    static const char *const ends[] = {
        [BATTEN_LINE_AT_LENGTH] = "where it is as long as asked for",
        [BATTEN_LINE_CLOSED] = "where it starts",
        [BATTEN_LINE_AT_RIM] = "on the rim",
        [BATTEN_LINE_AT_UMBILIC] = "at an umbilic",
        [BATTEN_LINE_AT_PARABOLIC] = "where the Gaussian curvature is 0",
        [BATTEN_LINE_AT_SINGULAR] = "at a pole or crease"};
    const char *unit = bat_unit_name(s->run);
    if (line->line.closed)
        bat_remark(s->run, "'%s': closed, %.6g %s long", name, line->length, unit);
    else
        bat_remark(s->run, "'%s': %.6g %s long; it begins %s and ends %s", name, line->length,
                   unit, goes_one_way ? "at its point" : ends[line->ends[0]],
                   ends[line->ends[1]]);
}

/* ---- lines ---- */

static batten_status put_line(search *s, const foot *at, const batten_line_start *start,
                              int number)
{
    char end[40], name[240];
    batten_surface_line line = {0};
    batten_curve *curve = NULL;
    const batten_object *on = object_at(s, at);
    batten_object like = *on;
    batten_status status =
        batten_surface_line_from(on->surface, start, s->within, s->run->job, &line);
    if (status != BATTEN_OK)
        return bat_fail(status, "line %d: %s", number, batten_message());
    snprintf(name, sizeof name, "%.180s %s", on->name,
             name_of(start->kind, number, end, sizeof end));
    like.name = name;
    status = bat_armed_curve(&line.line, line.arms, &curve);
    status = bat_put_curve_like(s->run, status, curve, &like, false);
    if (status == BATTEN_OK)
        tell_line(s, name, &line, start->kind == BATTEN_LINE_GEODESIC);
    s->error = bat_max(s->error, line.error);
    batten_surface_line_release(&line);
    return status;
}

/* Both lines of a pair; a geodesic in each direction. */
static batten_status put_lines(search *s, const foot *at, int number)
{
    const int kind = bat_word(s->run, "kind");
    const bat_argument *directions = bat_argument_of(s->run, "direction");
    const int count = kind == BATTEN_LINE_GEODESIC  ? directions->count
                      : kind > BATTEN_LINE_GEODESIC ? 2
                                                    : 1;
    const int first = kind == BOTH_CURVATURES    ? BATTEN_LINE_CURVATURE1
                      : kind == BOTH_ASYMPTOTICS ? BATTEN_LINE_ASYMPTOTIC1
                                                 : kind;
    batten_line_start start = {.u = at->uv[0], .v = at->uv[1]};
    batten_status status = BATTEN_OK;
    if (bat_has(s->run, "length"))
        start.length = bat_number(s->run, "length");
    for (int i = 0; i < count && status == BATTEN_OK; i++) {
        start.kind = (batten_line_kind)(kind == BATTEN_LINE_GEODESIC ? kind : first + i);
        if (kind == BATTEN_LINE_GEODESIC) {
            const double *d = directions->items[i].number;
            start.direction = (batten_vec3){d[0], d[1], d[2]};
        }
        status = put_line(s, at, &start,
                          kind == BATTEN_LINE_GEODESIC ? number * count + i + 1 : number + 1);
    }
    return status;
}

static void tell_idle(const search *s, const bool *used)
{
    for (int i = 0; i < s->surfaces.count; i++)
        if (!used[i])
            bat_remark(s->run, "'%s' has no line: no point is nearest to it",
                       s->surfaces.at[i]->name);
}

static batten_status put_all(search *s)
{
    const bat_argument *points = bat_argument_of(s->run, "through");
    bool *used = bat_array((size_t)s->surfaces.count, sizeof *used);
    batten_status status = used ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < points->count && status == BATTEN_OK; i++) {
        foot at;
        status = find_foot(s, points->items[i].number, &at);
        if (status == BATTEN_OK && at.distance > s->within)
            bat_remark(s->run, "point %d is %.6g %s off '%s': its lines start at the foot",
                       i + 1, at.distance, bat_unit_name(s->run), object_at(s, &at)->name);
        if (status == BATTEN_OK)
            status = put_lines(s, &at, i);
        if (status == BATTEN_OK)
            used[at.surface] = true;
    }
    if (status == BATTEN_OK)
        tell_idle(s, used);
    bat_release(used);
    return status;
}

static batten_status check_directions(const bat_run *run)
{
    const bool geodesic = bat_word(run, "kind") == BATTEN_LINE_GEODESIC;
    if (geodesic == bat_has(run, "direction"))
        return BATTEN_OK;
    return bat_fail(BATTEN_BAD_ARGUMENT,
                    geodesic ? "geodesics want a 'direction'"
                             : "'direction' is for geodesics: other lines have their own");
}

static batten_status run_surface_lines(bat_run *run)
{
    search s = {.run = run,
                .within =
                    bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run)};
    batten_status status = check_directions(run);
    if (status == BATTEN_OK)
        status = bat_gather(run, "surface-lines", BAT_SURFACES, &s.surfaces);
    if (status != BATTEN_OK)
        return status;
    status = put_all(&s);
    if (status == BATTEN_OK)
        bat_report_error(run, s.error, s.error);
    bat_objects_release(&s.surfaces);
    return status;
}

const bat_feature bat_feature_surface_lines = {
    .shown =
        {"surface-lines", "Lines of curvature, asymptotic lines and geodesics",
         "Each goes both ways from its start, a geodesic one way, until it is back, as long as\n"
         "asked for, or has no way on: at the rim, at a pole or a crease; lines of curvature\n"
         "at umbilics, where both principal curvatures are equal, asymptotic lines where the\n"
         "Gaussian curvature is 0. Remarks give lengths and ends. Lines are integrated by\n"
         "length, once more with a finer error, and the error reported is how far both are\n"
         "apart, with that of the cubics which are delivered.\n"
         "Plates are rolled along lines of curvature; a tape lies flat along a geodesic.",
         "features:\n"
         "  ring: {torus: 3 m, minor: 1 m}\n"
         "  nets: {surface-lines: ring, through: [[4 m, 0, 0], [0, 3 m, 1 m]], within: 1 mm}\n"
         "  tape: {surface-lines: ring, through: [[4 m, 0, 0]], kind: geodesic, direction: [0, 1, 1],\n"
         "         length: 20 m, within: 1 mm}\n",
         "[PM02]", "batten_surface_line_from", BAT_PARAMETERS(parameters), false,
         .formula = "    principal:  (II − κ I) · (u′, v′) = 0\n"
                    "    asymptotic:  L u′² + 2 M u′ v′ + N v′² = 0\n"
                    "    geodesic:  the curvature vector is normal to the surface",
         .promise = "Curves keep as close to the lines as the error says.",
         .also =
             "principal curvature lines, curvature net, geodesic, shortest path, asymptotic "
             "curves, tape, tow path, plate rolling"},
    .run = run_surface_lines,
    .displacing = "surface-lines"};
