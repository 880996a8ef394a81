/* The feature 'coons': the Coons patch between four sides. */
#include "base/plural.h"
#include "design/shared/boundary.h"
#include "design/shared/smooth.h"

static const batten_parameter parameters[] = {
    {"coons", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the boundary curves, in any order and direction"},
    BAT_BOUNDARY_SIDES,
    {"kind", BATTEN_VALUE_WORD, false, false, NULL, "first twists second third",
     "what it takes from the sides; by default 'first', with 'along' or 'slopes' 'second'"},
    {"blend", BATTEN_VALUE_WORD, false, false, NULL, "linear cubic quintic coons",
     "the blending functions; by default those that the kind needs"},
    {"blend-v", BATTEN_VALUE_WORD, false, false, NULL, "linear cubic quintic coons",
     "others from the first side to the opposite one"},
    {"functions", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "your own blending functions, F0 F1 G0 G1 H0 H1: graphs over 0 .. 1 in the xy-plane"},
    {"along", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "surfaces beside it that it continues smoothly; found by where they are"},
    {"slopes", BATTEN_VALUE_MODEL, true, false, NULL, NULL,
     "curves of vectors: the derivatives across the first boundary curves, inward, running as these do"},
    {"twists", BATTEN_VALUE_POINT, true, false, NULL, NULL,
     "one for all corners, or four: corners 1 to 4, around it from the start of the first side"},
    {"policy", BATTEN_VALUE_WORD, false, false, "gregory", "refuse keep-u keep-v mean gregory",
     "what to do where slopes of two sides ask for different twists"},
    {"repair", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "correct slopes that do not fit the boundary curves at a corner; the remaining angle is reported"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far corners may be open, and curves be from surfaces; the design's tolerance by default"},
    {"angle", BATTEN_VALUE_ANGLE, false, false, "0.01 deg", NULL,
     "with 'along' or 'slopes': how far the result may leave the tangent planes taken over"},
};

/* What a run takes and holds. */
typedef struct {
    bat_run *run;
    batten_surface_coons_options options;
    double twists[12];
    batten_curve *functions[6];
    bat_boundary boundary;
} work;

static void choose_kind(work *w)
{
    static const int orders[] = {1, 2, 2, 3};
    static const batten_blending blends[] = {BATTEN_BLENDING_LINEAR, BATTEN_BLENDING_CUBIC,
                                             BATTEN_BLENDING_CUBIC, BATTEN_BLENDING_QUINTIC};
    const bool has_slopes = bat_has(w->run, "along") || bat_has(w->run, "slopes");
    const int kind = bat_has(w->run, "kind") ? bat_word(w->run, "kind") : has_slopes ? 2 : 0;
    w->options.order = orders[kind];
    w->options.blending_u =
        bat_has(w->run, "blend") ? (batten_blending)bat_word(w->run, "blend") : blends[kind];
    w->options.blending_v = bat_has(w->run, "blend-v")
                                ? (batten_blending)bat_word(w->run, "blend-v")
                                : w->options.blending_u;
}

static batten_status choose_twists(work *w)
{
    const bat_argument *given = bat_argument_of(w->run, "twists");
    if (given->count == 0)
        return BATTEN_OK;
    if (given->count != 1 && given->count != 4)
        return bat_fail(BATTEN_BAD_ARGUMENT, "there are %d twists, not 1 or 4", given->count);
    if (w->options.order < 2)
        return bat_fail(BATTEN_BAD_ARGUMENT,
                        "a patch of the first kind takes no twists; 'kind: twists' does");
    for (int c = 0; c < 4; c++)
        for (int x = 0; x < 3; x++)
            w->twists[3 * c + x] = given->items[given->count == 4 ? c : 0].number[x];
    w->options.twists = w->twists;
    return BATTEN_OK;
}

/* y over x of a graph whose x is its parameter. */
static batten_status take_function(const batten_curve *graph, const char *name,
                                   batten_curve **out)
{
    const int d = batten_curve_dimension(graph), n = batten_curve_point_count(graph);
    const double *points = batten_curve_points(graph);
    if (d < 2 || batten_curve_is_rational(graph))
        return bat_fail(BATTEN_UNSUPPORTED, "'%s' is not a polynomial graph", name);
    double *values = bat_array((size_t)n, sizeof *values);
    if (!values)
        return BATTEN_OUT_OF_MEMORY;
    batten_status status = BATTEN_OK;
    for (int i = 0; status == BATTEN_OK && i < n; i++) {
        const double x = batten_curve_greville(graph, i);
        values[i] = points[i * d + 1];
        /* The graph is over 0 .. 1: abscissae are those of Greville but for the rounding of its maker. */
        if (!(fabs(points[i * d] - x) <= 1e-9) || (d > 2 && points[i * d + 2] != 0))
            status =
                bat_fail(BATTEN_NOT_COMPATIBLE,
                         "'%s' is not a graph over its parameter: control point %d is at %g, "
                         "not %g",
                         name, i + 1, points[i * d], x);
    }
    if (status == BATTEN_OK)
        status = batten_curve_create((batten_points){1, n, values}, batten_curve_degree(graph),
                                     NULL, batten_curve_knots(graph), out);
    bat_release(values);
    return status;
}

static batten_status choose_functions(work *w)
{
    bat_objects graphs;
    if (!bat_has(w->run, "functions"))
        return BATTEN_OK;
    batten_status status = bat_gather(w->run, "functions", BAT_CURVES, &graphs);
    if (status != BATTEN_OK)
        return status;
    if (graphs.count != 2 * w->options.order)
        status = bat_fail(BATTEN_BAD_ARGUMENT, "there are %d functions, this kind takes %d",
                          graphs.count, 2 * w->options.order);
    for (int i = 0; status == BATTEN_OK && i < graphs.count; i++)
        status = take_function(graphs.at[i]->curve, graphs.at[i]->name, &w->functions[i]);
    bat_objects_release(&graphs);
    w->options.blending_u = w->options.blending_v = BATTEN_BLENDING_GIVEN;
    w->options.given_u = w->options.given_v = (const batten_curve *const *)w->functions;
    return status;
}

static const char *edge_name(int edge)
{
    static const char *const names[] = {"the first side", "the second side", "the third side",
                                        "the fourth side"};
    return names[edge];
}

#define DEGREES (180 / BAT_PI)
/* Radians; less is rounding of a slope and of the curve beside it. */
static const double in_plane = 1e-6;

/* What helps where a boundary curve does not fit the slope beside it: it leaves the tangent plane, or has another direction
 * or speed in it, which the kinds with curvatures cannot make up for. */
static batten_status advise(const work *w, const batten_surface_coons_report *found,
                            batten_status status)
{
    if (status != BATTEN_NOT_COMPATIBLE || !(found->slope_gap > w->options.tolerance) ||
        w->options.repair)
        return status;
    const char *advice =
        w->options.order > 2 && found->slope_angle <= in_plane
            ? "with curvatures a slope is taken over with one factor for its whole side: let "
              "the boundary curves continue the curves across the surface beside it "
              "('curve-of'), both with the same ratio of speeds, or take 'kind: second'"
            : "let the boundary curves leave within the tangent planes ('curve-of' and "
              "'blend' with G1)";
    return bat_fail(status, "%s; %s, or correct the slopes ('repair: yes')", batten_message(),
                    advice);
}

/* The slopes that gave way; how far from smooth the joins are now is measured later. */
static void report_repair(const work *w, const batten_surface_coons_report *found)
{
    bat_note(
        w->run,
        "slope and boundary curve differ by %.3g per unit of the parameter at corner %d, "
        "where the curve leaves the tangent plane at %.3g degree%s; the slope is corrected",
        found->slope_gap, found->slope_corner, found->slope_angle * DEGREES,
        bat_plural_real(found->slope_angle * DEGREES, 3));
}

/* What did not fit, and what became of it. */
static void report(const work *w, const batten_surface_coons_report *found)
{
    bat_run *run = w->run;
    const double tolerance = w->options.tolerance;
    /* Gaps that are a millionth of the tolerance are rounding, not worth a remark. */
    if (found->corner_gap > 1e-6 * tolerance)
        bat_remark(run, "the curves are up to %.3g apart, at corner %d; they meet halfway",
                   found->corner_gap, found->corner);
    if (found->slope_gap > tolerance)
        report_repair(w, found);
    if (found->twist_gap > tolerance)
        bat_note(run, "the slopes ask for twists that differ by %.3g at corner %d%s",
                 found->twist_gap, found->twist_corner,
                 w->options.twist == BATTEN_TWIST_GREGORY
                     ? "; the twist turns there, which a spline follows within 'angle'"
                     : "");
    if (found->higher_gap > tolerance)
        bat_note(run, "curvatures and their rates differ by up to %.3g at a corner",
                 found->higher_gap);
    for (int e = 0; e < 4; e++)
        for (int k = 1; k < w->options.order; k++)
            if (found->missed[e][k] > tolerance)
                bat_note(run, "%s across %s is missed by up to %.3g per unit of the parameter",
                         k == 1 ? "the slope" : "the second derivative", edge_name(e),
                         found->missed[e][k]);
}

/* What crosses the sides: out of the surfaces beside it, or as it is given. */
static batten_status choose_slopes(work *w)
{
    if (bat_has(w->run, "along") && bat_has(w->run, "slopes"))
        return bat_fail(
            BATTEN_BAD_ARGUMENT,
            "'along' and 'slopes' both say how the patch leaves its sides: give one");
    if (bat_has(w->run, "slopes"))
        return bat_boundary_slopes(w->run, "slopes", w->options.order, &w->boundary);
    if (bat_has(w->run, "along"))
        return bat_boundary_along(w->run, "along", w->options.order, w->options.tolerance,
                                  &w->boundary);
    return BATTEN_OK;
}

static batten_status make_coons(work *w, batten_surface **out)
{
    batten_surface_coons_report found = {0};
    choose_kind(w);
    w->options.twist = (batten_twist_policy)bat_word(w->run, "policy");
    w->options.repair = bat_yes(w->run, "repair");
    w->options.tolerance =
        bat_has(w->run, "within") ? bat_number(w->run, "within") : bat_tolerance(w->run);
    batten_status status = choose_twists(w);
    if (status == BATTEN_OK)
        status = choose_functions(w);
    if (status == BATTEN_OK)
        status = bat_boundary_take(w->run, "coons", w->options.tolerance, &w->boundary);
    if (status == BATTEN_OK)
        status = choose_slopes(w);
    if (status == BATTEN_OK)
        status = batten_surface_coons(w->boundary.sides, &w->options, &found, out);
    if (status == BATTEN_OK)
        report(w, &found);
    return advise(w, &found, status);
}

static batten_status run_coons(bat_run *run)
{
    batten_surface *surface = NULL;
    work w = {.run = run, .options = batten_surface_coons_defaults()};
    batten_status status = make_coons(&w, &surface);
    bat_smooth_wish wish = {.within = bat_tolerance(run),
                            .angle = bat_number(run, "angle"),
                            .curvature = w.options.order > 2,
                            .gives_way =
                                w.options.repair || w.options.twist != BATTEN_TWIST_GREGORY};
    for (int e = 0; e < 4; e++) {
        wish.names[e] = w.boundary.sides[e].slope ? edge_name(e) : NULL;
        wish.beside[e] = w.boundary.beside[e];
    }
    const bool is_smooth = bat_has(run, "along") || bat_has(run, "slopes");
    status = is_smooth ? bat_put_smooth_surface(run, status, surface, &wish)
                       : bat_put_surface(run, status, surface);
    bat_boundary_release(&w.boundary);
    for (int i = 0; i < 6; i++)
        batten_curve_unref(w.functions[i]);
    return status;
}

const bat_feature bat_feature_coons = {
    .shown =
        {"coons", "The Coons patch between four sides",
         "u runs along the first side, v along the second. A side may be several curves end to end,\n"
         "with corners, or a single point: 'sides' says how many curves each has. Kinds: 'first'\n"
         "passes through the curves and no more, 'twists' also has given twists at its corners\n"
         "(instead of those of the bilinear patch), which cures flat spots; 'second' has the slopes\n"
         "of the surfaces it lies along or those that are given, 'third' curvatures too. Blending\n"
         "functions: 'linear' ('first' only), 'cubic', and 'quintic' or 'coons' for patchworks with\n"
         "continuous curvature. By default 'linear' for 'first', 'quintic' for 'third', otherwise\n"
         "'cubic'. A slope fits its neighbours when the boundary curves beside it leave the surface\n"
         "within its tangent plane; of the kind 'third' they also continue the curves across it, both\n"
         "with the same ratio of speeds. Such curves come from 'curve-of' (the ends of the surface)\n"
         "and 'blend' between them with continuity G1; 'repair: yes' corrects the slopes instead and\n"
         "reports by how many degrees the patch then leaves the tangent planes. Gaps between slopes\n"
         "are vectors per unit of the parameter. Unless curves are rational, or twists differ under\n"
         "the policy 'gregory', the result is exact; otherwise a spline. Tangent planes, and\n"
         "curvatures of the kind 'third', are measured along every side against the surfaces given;\n"
         "more than 'angle' is noted, or refused when you state the angle.",
         "features:\n"
         "  keel: {line: [[0, 0, 0], [4, 0, 0]]}\n"
         "  stern: {conic: [[0, 0, 0], [0, 1, 0.2], [0, 1, 1.5]], weight: 1}\n"
         "  sheer: {conic: [[0, 1, 1.5], [2, 1.6, 1.2], [4, 0.4, 1.6]], weight: 1}\n"
         "  bow: {conic: [[4, 0.4, 1.6], [4, 0.2, 0.6], [4, 0, 0]], weight: 1}\n"
         "  side: {coons: [keel, bow, stern, sheer], kind: twists}\n",
         "[SL section V.2] [Utah74 paper 1] [Utah74 paper 4] [Coons67] [Coons74] [PT97 section 10.6]",
         "batten_surface_coons", BAT_PARAMETERS(parameters), false,
         .also =
             "Coons patch, boundary patch, transfinite, four-sided patch, bilinearly blended, flat spot, twist",
         .formula =
             "    S = Σ F_i(u) d_i(v) + Σ c_j(u) F_j(v) − Σ Σ F_i(u) r_ij F_j(v)   (first kind)\n"
             "    second kind: with G_i times the slopes across the sides;  twists: + Σ Σ G_i(u) T_ij G_j(v)",
         .promise =
             "The sides are met exactly; slopes and curvatures of the kinds second and third are measured on what is delivered."},
    .run = run_coons,
    .beside = "functions along slopes"};
