/* The feature 'gordon': the surface through a network of curves. */
#include "base/plural.h"
#include "design/shared/sweeps.h"

#include <batten/gordon.h>

#include <stdio.h>

static const batten_parameter parameters[] = {
    {"gordon", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the profiles; or, without guides, the curves of both families in any order"},
    {"guides", BATTEN_VALUE_MODEL, true, false, NULL, NULL, "the curves across the profiles"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far the surface may be from a curve; the design's tolerance, or the size / 10000"},
    {"gap", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "how far curves may miss each other; 'within', else the tolerance or the size / 1000"},
    {"blend", BATTEN_VALUE_WORD, false, false, "spline", "spline linear lagrange",
     "how a curve fades out towards its neighbours"},
    {"cut", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "cut curves that extend beyond the network; otherwise they are refused"},
};

/* One family: its curves and what they are called. */
typedef struct {
    int count;
    const batten_curve **curves;
    const char **names;
} family;

typedef struct {
    bat_objects objects[2]; /* of profiles and guides */
    bat_tipped curves[2];
    family profiles, guides;
    double within, gap;
} network;

/* A tolerance for parts of a metre would eat a model of a millimetre. */
enum { WITHIN_PARTS = 10000, GAP_PARTS = 1000 };

static batten_status make_room(family *f, int count)
{
    f->curves = bat_array((size_t)count, sizeof *f->curves);
    f->names = bat_array((size_t)count, sizeof *f->names);
    return f->curves && f->names ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

/* Curve i of a list. */
static void add_gordon(family *f, const network *n, int list, int i)
{
    f->curves[f->count] = n->curves[list].curves[i];
    f->names[f->count++] = n->objects[list].at[i]->name;
}

static void release(network *n)
{
    for (int list = 0; list < 2; list++) {
        bat_tipped_release(&n->curves[list]);
        bat_objects_release(&n->objects[list]);
    }
    bat_release(n->profiles.curves);
    bat_release(n->profiles.names);
    bat_release(n->guides.curves);
    bat_release(n->guides.names);
}

/* ---- who crosses whom ---- */

static batten_status split(const bat_run *run, network *n)
{
    family mixed = {0};
    const int count = n->objects[0].count;
    int *side = bat_array((size_t)count, sizeof *side);
    batten_status status = make_room(&mixed, count);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        add_gordon(&mixed, n, 0, i);
    if (status == BATTEN_OK && !side)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_network_split(count, mixed.curves, n->gap, mixed.names, run->job, side);
    for (int i = 0; status == BATTEN_OK && i < count; i++)
        add_gordon(side[i] == 0 ? &n->profiles : &n->guides, n, 0, i);
    bat_release(side);
    bat_release(mixed.names);
    bat_release(mixed.curves);
    return status;
}

static batten_status set_tolerances(bat_run *run, network *n)
{
    const int first = n->objects[0].count, count = first + n->objects[1].count;
    const batten_curve **all = bat_array((size_t)count, sizeof *all);
    if (!all)
        return BATTEN_OUT_OF_MEMORY;
    for (int i = 0; i < count; i++)
        all[i] = i < first ? n->curves[0].curves[i] : n->curves[1].curves[i - first];
    const double size = batten_network_size(count, all), tolerance = bat_tolerance(run);
    bat_release(all);
    const double least =
        size > 0 ? size : tolerance * GAP_PARTS; /* one point is refused later */
    n->within = bat_has(run, "within") ? bat_number(run, "within")
                                       : bat_min(tolerance, least / WITHIN_PARTS);
    n->gap = bat_has(run, "gap")      ? bat_number(run, "gap")
             : bat_has(run, "within") ? n->within
                                      : bat_min(tolerance, least / GAP_PARTS);
    if (!bat_has(run, "within") && n->within < tolerance)
        bat_remark(
            run,
            "the network is %.3g across: the surface is made within %.3g, not the design's "
            "tolerance %g",
            size, n->within, tolerance);
    return BATTEN_OK;
}

static batten_status gather_list(bat_run *run, const char *parameter, int list, network *n)
{
    const batten_status status =
        bat_gather(run, parameter, BAT_CURVES | BAT_POINTS, &n->objects[list]);
    return status == BATTEN_OK ? bat_take_tipped(&n->objects[list], &n->curves[list]) : status;
}

static batten_status gather(bat_run *run, network *n)
{
    const bool two = bat_has(run, "guides");
    batten_status status = gather_list(run, "gordon", 0, n);
    if (status == BATTEN_OK && two)
        status = gather_list(run, "guides", 1, n);
    if (status == BATTEN_OK)
        status = set_tolerances(run, n);
    const int profiles = n->objects[0].count, guides = n->objects[1].count;
    if (status == BATTEN_OK)
        status = make_room(&n->profiles, profiles);
    if (status == BATTEN_OK)
        status = make_room(&n->guides, two ? guides : profiles);
    if (status != BATTEN_OK)
        return status;
    if (!two)
        return split(run, n);
    for (int i = 0; i < profiles; i++)
        add_gordon(&n->profiles, n, 0, i);
    for (int i = 0; i < guides; i++)
        add_gordon(&n->guides, n, 1, i);
    return BATTEN_OK;
}

/* ---- notes ---- */

enum { LABEL = 160 };

/* The same words as in the kernel's failures: a file may give both families the same names. */
static const char *label(const network *n, bool is_guide, int k, char text[LABEL])
{
    const family *f = is_guide ? &n->guides : &n->profiles;
    snprintf(text, LABEL, "%s '%.100s' (%d of %d)", is_guide ? "guide" : "profile", f->names[k],
             k + 1, f->count);
    return text;
}

/* The largest number with one digit that is not above x. */
static double one_digit(double x)
{
    const double unit = bat_pow(10, floor(bat_log10(x)));
    return bat_max(1, floor(x / unit * (1 + 1e-12))) * unit;
}

/* Would what `within` allows be seen, at the size of the network or beside its neighbours? */
static void tell_coarse(bat_run *run, const network *n, const batten_surface_gordon_report *r)
{
    const double parts = r->size / WITHIN_PARTS, tenth = r->nearest / 10;
    char names[2][LABEL];
    /* What is just that part, but for rounding, is not coarse. */
    if (n->within > parts * (1 + 1e-9))
        bat_remark(run,
                   "within %.3g is coarse for a network that is %.3g across; try within: %.1g",
                   n->within, r->size, one_digit(bat_min(parts, tenth)));
    else if (n->within > tenth)
        bat_remark(run,
                   "within %.3g is coarse where %s and %s are %.3g apart; try within: %.1g",
                   n->within, label(n, r->nearest_is_guide, r->nearest_curves[0], names[0]),
                   label(n, r->nearest_is_guide, r->nearest_curves[1], names[1]), r->nearest,
                   one_digit(tenth));
}

/* Curves that are not used as they were given. */
static void tell_changes(bat_run *run, const network *n, const batten_surface_gordon_report *r)
{
    char names[2][LABEL];
    if (r->cut_count > 0)
        bat_remark(run, "curves that extend beyond the network: %d; cut by up to %.3g",
                   r->cut_count, r->cut);
    if (r->reversed_count > 0)
        bat_remark(run, "%d curve%s %s run backwards", r->reversed_count,
                   bat_plural(r->reversed_count),
                   bat_one_or_many(r->reversed_count, "is", "are"));
    for (int i = 0; i < r->repeated_count && i < BATTEN_GORDON_REPEATED; i++)
        bat_remark(run, "%s is %s again, %.3g away at most, and is left out",
                   label(n, r->repeated[i].is_guide, r->repeated[i].left, names[0]),
                   label(n, r->repeated[i].is_guide, r->repeated[i].used, names[1]),
                   r->repeated[i].apart);
    if (r->repeated_count > BATTEN_GORDON_REPEATED)
        bat_remark(run, "curves given more than once: %d; left out", r->repeated_count);
    /* Ends closer than a millionth of the network are one point: nothing to remark. */
    if (r->seam > r->size * 1e-6)
        bat_remark(run, "%s is taken as closed: its ends are %.3g apart, the widest",
                   label(n, r->seam_is_guide, r->seam_curve, names[0]), r->seam);
    if (r->pole_count > 0)
        bat_remark(run, "%d pole%s, in which one family ends", r->pole_count,
                   bat_plural(r->pole_count));
}

static void remark_network(bat_run *run, const network *n,
                           const batten_surface_gordon_report *r)
{
    char names[2][LABEL];
    bat_remark(run, "%d profile%s and %d guide%s: %d by %d control points", n->profiles.count,
               bat_plural(n->profiles.count), n->guides.count, bat_plural(n->guides.count),
               r->points_u, r->points_v);
    if (r->worst >= 0 && r->error > 0)
        bat_remark(run, "%s is %.3g away, the farthest",
                   label(n, r->worst_is_guide, r->worst, names[0]), r->error);
    if (r->gap > n->within / 100)
        bat_remark(run, "%s and %s are %.3g apart, the widest gap",
                   label(n, false, r->gap_profile, names[0]),
                   label(n, true, r->gap_guide, names[1]), r->gap);
    if (r->guide_error > n->within)
        bat_remark(
            run,
            "what the guides do between the profiles is in the surface, waves too: %s "
            "leaves the skin of the profiles alone by up to %.3g, near (%.4g, %.4g, %.4g)",
            label(n, true, r->guide_worst, names[0]), r->guide_error, r->guide_worst_at.x,
            r->guide_worst_at.y, r->guide_worst_at.z);
    tell_coarse(run, n, r);
    tell_changes(run, n, r);
}

static batten_status make_gordon(bat_run *run, const network *n)
{
    batten_surface_gordon_options options = batten_surface_gordon_defaults();
    batten_surface_gordon_report report;
    batten_surface *surface = NULL;
    options.tolerance = n->within;
    options.gap = n->gap;
    options.blend = (batten_gordon_blend)bat_word(run, "blend");
    options.cut = bat_yes(run, "cut");
    options.profile_names = n->profiles.names;
    options.guide_names = n->guides.names;
    batten_status status =
        batten_surface_gordon((batten_curve_row){n->profiles.count, n->profiles.curves},
                              (batten_curve_row){n->guides.count, n->guides.curves}, &options,
                              run->job, &report, &surface);
    if (status != BATTEN_OK)
        return status;
    remark_network(run, n, &report);
    bat_report_error(run, report.error, report.error);
    return bat_put_surface(run, status, surface);
}

static batten_status run_gordon(bat_run *run)
{
    network n = {.within = 0};
    batten_status status = gather(run, &n);
    if (status == BATTEN_OK)
        status = make_gordon(run, &n);
    release(&n);
    return status;
}

const bat_feature bat_feature_gordon = {
    .shown =
        {"gordon", "The surface through a network of curves",
         "Two families of curves, each of which meets all those of the other once. Their order,\n"
         "their directions and where they meet are found; curves of different speed are\n"
         "reparametrised. Closed curves make a closed surface, periodic where smooth; curves of one\n"
         "family may end in a common point, which may be given as the first or last of the other\n"
         "family. A surface can be within a small tolerance of curves that miss each other by more:\n"
         "it runs midway in such gaps. Without 'guides' one list holds both families, and which\n"
         "curve crosses which is found. u runs along the profiles.",
         "features:\n"
         "  a: {polyline: [[0, 0, 0], [3 m, 0, 1 m]]}\n"
         "  b: {polyline: [[0, 2 m, 0], [3 m, 2 m, 0.5 m]]}\n"
         "  q: {points: [[0, 0, 0], [0, 1 m, 0.4 m], [0, 2 m, 0]]}\n"
         "  left: {interpolate: q}\n"
         "  right: {polyline: [[3 m, 0, 1 m], [3 m, 2 m, 0.5 m]]}\n"
         "  shell: {gordon: [a, b], guides: [left, right]}\n",
         "[PT97 section 10.5] [Gordon71]", "batten_surface_gordon", BAT_PARAMETERS(parameters),
         false,
         .also =
             "network surface, curve network, boundary surface, transfinite interpolation, guides, curves in two directions",
         .formula =
             "    S = Σ L_i(u) f_i(v) + Σ M_j(v) g_j(u) − Σ Σ L_i(u) M_j(v) X_ij,  L_i(u_k) = δ_ik,  M_j(v_l) = δ_jl",
         .promise = "All curves are met, but for gaps between them, which are reported."},
    .run = run_gordon};
