#include "design/feature.h"

#include <batten/gordon.h>

static const batten_parameter parameters[] = {
    {"gordon", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "the profiles; or, without guides, the curves of both families in any order"},
    {"guides", BATTEN_VALUE_MODEL, true, false, NULL, NULL, "the curves across the profiles"},
    {"within", BATTEN_VALUE_LENGTH, false, false, NULL, NULL,
     "the widest gap, and how far the surface may be from a curve; the design's tolerance"},
    {"blend", BATTEN_VALUE_WORD, false, false, "spline", "spline linear lagrange",
     "how a curve fades out towards its neighbours"},
    {"cut", BATTEN_VALUE_YES_NO, false, false, "yes", NULL,
     "cut curves that go on beyond the network; else they are refused"},
};

/* One family: its curves and what they are called. */
typedef struct {
    int count;
    const batten_curve **curves;
    const char **names;
} family;

typedef struct {
    family profiles, guides;
    double tolerance;
} network;

static batten_status make_room(family *f, int count)
{
    f->curves = bat_array((size_t)count, sizeof *f->curves);
    f->names = bat_array((size_t)count, sizeof *f->names);
    return f->curves && f->names ? BATTEN_OK : BATTEN_OUT_OF_MEMORY;
}

static void add(family *f, const batten_object *object)
{
    f->curves[f->count] = object->curve;
    f->names[f->count++] = object->name;
}

static void release(network *n)
{
    bat_release(n->profiles.curves);
    bat_release(n->profiles.names);
    bat_release(n->guides.curves);
    bat_release(n->guides.names);
}

/* ---- who crosses whom ---- */

static batten_status split(const bat_run *run, const bat_objects *all, network *n)
{
    family mixed = {0};
    int *side = bat_array((size_t)all->count, sizeof *side);
    batten_status status = make_room(&mixed, all->count);
    for (int i = 0; status == BATTEN_OK && i < all->count; i++)
        add(&mixed, all->at[i]);
    if (status == BATTEN_OK && !side)
        status = BATTEN_OUT_OF_MEMORY;
    if (status == BATTEN_OK)
        status = batten_network_split(all->count, mixed.curves, n->tolerance, mixed.names,
                                      run->job, side);
    for (int i = 0; status == BATTEN_OK && i < all->count; i++)
        add(side[i] == 0 ? &n->profiles : &n->guides, all->at[i]);
    bat_release(side);
    bat_release(mixed.names);
    bat_release(mixed.curves);
    return status;
}

static batten_status gather(const bat_run *run, network *n, bat_objects *profiles,
                            bat_objects *guides)
{
    const bool two = bat_has(run, "guides");
    batten_status status = bat_gather(run, "gordon", BAT_CURVES, profiles);
    if (status == BATTEN_OK && two)
        status = bat_gather(run, "guides", BAT_CURVES, guides);
    if (status == BATTEN_OK)
        status = make_room(&n->profiles, profiles->count);
    if (status == BATTEN_OK)
        status = make_room(&n->guides, two ? guides->count : profiles->count);
    if (status != BATTEN_OK)
        return status;
    if (!two)
        return split(run, profiles, n);
    for (int i = 0; i < profiles->count; i++)
        add(&n->profiles, profiles->at[i]);
    for (int i = 0; i < guides->count; i++)
        add(&n->guides, guides->at[i]);
    return BATTEN_OK;
}

/* ---- what is said ---- */

static void tell(const bat_run *run, const network *n, const batten_gordon_report *r)
{
    const family *worst = r->worst_is_guide ? &n->guides : &n->profiles;
    bat_remark(run, "%d profiles and %d guides: %d by %d control points", n->profiles.count,
               n->guides.count, r->points_u, r->points_v);
    if (r->worst >= 0 && r->deviation > 0)
        bat_remark(run, "'%s' is %.3g away, the farthest", worst->names[r->worst],
                   r->deviation);
    if (r->gap > n->tolerance / 100)
        bat_remark(run, "'%s' and '%s' are %.3g apart, the widest gap",
                   n->profiles.names[r->gap_profile], n->guides.names[r->gap_guide], r->gap);
    if (r->cut_count > 0)
        bat_remark(run, "%d curves go on beyond the network and are cut, up to %.3g",
                   r->cut_count, r->cut);
    if (r->reversed_count > 0)
        bat_remark(run, "%d curves are run backwards", r->reversed_count);
    if (r->repeated_count > 0)
        bat_remark(run, "%d curves stand there twice and are used once", r->repeated_count);
    if (r->pole_count > 0)
        bat_remark(run, "%d poles, in which one family ends", r->pole_count);
}

static batten_status make(bat_run *run, const network *n)
{
    batten_gordon_options options = batten_gordon_defaults();
    batten_gordon_report report;
    batten_surface *surface = NULL;
    options.tolerance = n->tolerance;
    options.blend = (batten_gordon_blend)bat_word(run, "blend");
    options.cut = bat_yes(run, "cut");
    options.profile_names = n->profiles.names;
    options.guide_names = n->guides.names;
    batten_status status =
        batten_surface_gordon(n->profiles.count, n->profiles.curves, n->guides.count,
                              n->guides.curves, &options, run->job, &report, &surface);
    if (status != BATTEN_OK)
        return status;
    tell(run, n, &report);
    bat_report_error(run, report.deviation, report.deviation);
    return bat_put_surface(run, status, surface);
}

static batten_status run(bat_run *run)
{
    bat_objects profiles = {0}, guides = {0};
    network n = {.tolerance =
                     bat_has(run, "within") ? bat_number(run, "within") : bat_tolerance(run)};
    batten_status status = gather(run, &n, &profiles, &guides);
    if (status == BATTEN_OK)
        status = make(run, &n);
    release(&n);
    bat_objects_release(&guides);
    bat_objects_release(&profiles);
    return status;
}

const bat_feature bat_feature_gordon = {
    .shown = {"gordon", "The surface through a network of curves",
              "Two families of curves, each of which meets all those of the other once. Their "
              "order\n"
              "and directions are found, and where they meet; curves of different speed are\n"
              "reparametrised. Closed curves make a closed surface, periodic where smooth; "
              "curves of\n"
              "one family may end in a common point. Without 'guides' one list holds both "
              "families,\n"
              "and it is found out which curve crosses which. u runs along the profiles.",
              "features:\n"
              "  a: {polyline: [[0, 0, 0], [3 m, 0, 1 m]]}\n"
              "  b: {polyline: [[0, 2 m, 0], [3 m, 2 m, 0.5 m]]}\n"
              "  q: {points: [[0, 0, 0], [0, 1 m, 0.4 m], [0, 2 m, 0]]}\n"
              "  left: {interpolate: q}\n"
              "  right: {polyline: [[3 m, 0, 1 m], [3 m, 2 m, 0.5 m]]}\n"
              "  shell: {gordon: [a, b], guides: [left, right]}\n",
              "[Gordon71]", "batten_surface_gordon", BAT_PARAMETERS(parameters), false},
    .run = run};
