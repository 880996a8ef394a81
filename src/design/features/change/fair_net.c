/* The feature 'fair-net': a net of points moved within a bound until the surface through it is fair. */
#include "base/plural.h"
#include "design/shared/grid.h"
#include "design/shared/place.h"

#include <batten/fair.h>
#include <stdio.h>
#include <string.h>

/* So many points that look like blunders are named one by one. */
#define MOST_SUSPECTS 10

typedef enum { AS_SURFACE, AS_POINTS } form;

static const batten_parameter parameters[] = {
    {"fair-net", BATTEN_VALUE_MODEL, true, true, NULL, NULL,
     "rows of points, all of the same length, or a table of offsets without gaps"},
    {"within", BATTEN_VALUE_LENGTH, false, true, NULL, NULL,
     "no point moves farther than this"},
    {"method", BATTEN_VALUE_WORD, false, false, "energy", "energy least-change",
     "by what points are moved"},
    {"hold", BATTEN_VALUE_WORD, false, false, "nothing", "nothing edges tangents curvatures",
     "what stays at the rim; tangents and curvatures by least change"},
    {"held-points", BATTEN_VALUE_COUNT, true, false, NULL, NULL,
     "points that stay, counted from 1 row after row"},
    {"blunders", BATTEN_VALUE_WORD, false, false, "name", "name mend",
     "points that look like blunders are named, or put where their neighbours have them"},
    {"parameters", BATTEN_VALUE_WORD, false, false, "chord", "chord uniform centripetal",
     "how parameters are given to the points"},
    {"periodic-u", BATTEN_VALUE_YES_NO, false, false, "no", NULL, "the rows close smoothly"},
    {"periodic-v", BATTEN_VALUE_YES_NO, false, false, "no", NULL,
     "the first row follows the last"},
    {"form", BATTEN_VALUE_WORD, false, false, "surface", "surface points",
     "the surface through the moved points, or the rows of them"},
};

/* ---- what is asked ---- */

static batten_status find_bounds(const bat_run *run, const bat_grid *grid, double **out)
{
    const bat_argument *held = bat_argument_of(run, "held-points");
    const int count = grid->count_u * grid->count_v;
    if (held->count == 0)
        return BATTEN_OK;
    *out = bat_array((size_t)count, sizeof **out);
    if (!*out)
        return BATTEN_OUT_OF_MEMORY;
    for (int k = 0; k < count; k++)
        (*out)[k] = bat_number(run, "within");
    for (int k = 0; k < held->count; k++) {
        const int number = held->items[k].count;
        if (number < 1 || number > count)
            return bat_fail(BATTEN_BAD_ARGUMENT,
                            "point %d is to be held: the points are counted 1 to %d", number,
                            count);
        const int row = (number - 1) / grid->count_u, place = (number - 1) % grid->count_u;
        (*out)[place * grid->count_v + row] = 0;
    }
    return BATTEN_OK;
}

static batten_net_fair_options options_of(const bat_run *run)
{
    static const batten_parametrization parametrizations[] = {BATTEN_CHORD, BATTEN_UNIFORM,
                                                              BATTEN_CENTRIPETAL};
    batten_net_fair_options options = batten_net_fair_defaults(bat_number(run, "within"));
    options.method = (batten_net_fair_method)bat_word(run, "method");
    options.hold = bat_word(run, "hold");
    options.mend_blunders = bat_word(run, "blunders") == 1;
    options.parameters = parametrizations[bat_word(run, "parameters")];
    options.closed_u = bat_yes(run, "periodic-u");
    options.closed_v = bat_yes(run, "periodic-v");
    return options;
}

/* ---- what is said ---- */

static void note_suspects(const bat_run *run, const batten_fair_report *found)
{
    const bool mended = bat_word(run, "blunders") == 1;
    for (int k = 0; k < found->suspect_count && k < MOST_SUSPECTS; k++) {
        const batten_fair_move *s = found->suspects + k;
        bat_note(run, "point %d of row %d, (%g, %g, %g), looks like a blunder; (%g, %g, %g) %s",
                 s->index + 1, s->set + 1, s->from[0], s->from[1], s->from[2], s->to[0],
                 s->to[1], s->to[2], mended ? "stands for it" : "would fit");
    }
    if (found->suspect_count > MOST_SUSPECTS)
        bat_note(run, "%d more point%s %s like blunders", found->suspect_count - MOST_SUSPECTS,
                 bat_plural(found->suspect_count - MOST_SUSPECTS),
                 bat_one_or_many(found->suspect_count - MOST_SUSPECTS, "looks", "look"));
}

static void note_excess(const bat_run *run, const batten_net_fair_report *found)
{
    const int count = found->sections_after;
    const bool holds =
        bat_word(run, "hold") > 0 || bat_argument_of(run, "held-points")->count > 0;
    if (count == 0)
        return;
    if (bat_word(run, "method") == BATTEN_NET_FAIR_ENERGY)
        bat_note(
            run,
            "%d of %d sections %s inflections in excess: least energy does not count them, "
            "'method: least-change' may remove them",
            count, found->section_count, bat_one_or_many(count, "has", "have"));
    else
        bat_note(run,
                 "%d of %d sections %s inflections in excess: no surface with fewer was found "
                 "within the bound%s",
                 count, found->section_count, bat_one_or_many(count, "keeps", "keep"),
                 holds ? " and with the points that are held" : "");
}

static void report_net(bat_run *run, batten_net_fair_report *found)
{
    batten_feature_result *shown = &run->result->shown;
    bat_remark(
        run, "%d of %d sections had inflections in excess, %d %s; no bulge up to %.2g is seen",
        found->sections_before, found->section_count, found->sections_after,
        bat_one_or_many(found->sections_after, "has", "have"), found->height);
    note_excess(run, found);
    note_suspects(run, &found->points);
    run->result->fairing = found->points;
    run->result->fairing_bound = bat_number(run, "within");
    shown->has_moves = true;
    shown->move_max = found->points.max_move;
    shown->moved_count = found->points.moved_count;
}

/* ---- what is made ---- */

static batten_status put_rows(bat_run *run, const bat_grid *grid, const double *faired)
{
    double *row = bat_array3((size_t)grid->count_u, 3, sizeof *row);
    batten_status status = row ? bat_expect(run, grid->count_v) : BATTEN_OUT_OF_MEMORY;
    for (int j = 0; j < grid->count_v && status == BATTEN_OK; j++) {
        char name[220];
        snprintf(name, sizeof name, "%.200s %d", run->name, j + 1);
        for (int i = 0; i < grid->count_u; i++)
            memcpy(row + 3 * i, faired + 3 * ((size_t)i * (size_t)grid->count_v + (size_t)j),
                   3 * sizeof *row);
        status = bat_add(run, &(batten_object){.name = name,
                                               .layer = "",
                                               .group = "",
                                               .kind = BATTEN_OBJECT_POINTS,
                                               .point_count = grid->count_u,
                                               .points = row});
    }
    bat_release(row);
    return status;
}

static batten_status fair_grid(bat_run *run, const bat_grid *grid)
{
    batten_net_fair_options options = options_of(run);
    batten_net_fair_report report = {0};
    batten_surface *surface = NULL;
    double *within = NULL;
    double *faired =
        bat_array3((size_t)grid->count_u, (size_t)grid->count_v, 3 * sizeof *faired);
    batten_status status = faired ? find_bounds(run, grid, &within) : BATTEN_OUT_OF_MEMORY;
    options.within_each = within;
    if (status == BATTEN_OK)
        status = batten_fair_net((batten_grid){3, grid->count_u, grid->count_v, grid->points},
                                 &options, run->job, &report, faired, &surface);
    if (status == BATTEN_OK)
        report_net(run, &report);
    if (status == BATTEN_OK && bat_word(run, "form") == AS_POINTS) {
        batten_surface_unref(surface);
        status = put_rows(run, grid, faired);
    } else {
        status = bat_put_surface(run, status, surface);
    }
    bat_release(within);
    bat_release(faired);
    return status;
}

static batten_status run_fair_net(bat_run *run)
{
    bat_grid grid = {0, 0, NULL};
    batten_status status = bat_grid_of(run, "fair-net", &grid);
    if (status == BATTEN_OK)
        status = fair_grid(run, &grid);
    bat_grid_release(&grid);
    return status;
}

const bat_feature bat_feature_fair_net = {
    .shown =
        {"fair-net",
         "A net of points moved within a bound until the surface through it is fair",
         "By 'energy' the points go where battens along all rows and columns have the least energy\n"
         "together; a node is one point of both, so the net stays one. By 'least-change' they\n"
         "move as little as removes inflections in excess from plane sections across the rows, across\n"
         "the columns and along both diagonals; a net without any comes back as it was.\n"
         "Either way no point leaves the ball of 'within' about where it was given, in all three\n"
         "coordinates, and the result is the bicubic spline through the moved points, or with 'form:\n"
         "points' their rows.\n\n"
         "'hold' keeps the edges of the surface, and by least change its tangent planes or curvatures\n"
         "along them too. A section needs the inflections that the surface of least energy within\n"
         "the bound has, of bulges above the bound. Points that stick out from their row and from\n"
         "their column are named, the worst first, with the place that would fit; 'blunders: mend'\n"
         "puts them there, and the bound counts from that place. The output 'corrections' lists\n"
         "what moved.",
         "features:\n"
         "  net:\n"
         "    points: [[0, 0, 0], [1, 0, 0.3], [2, 0, 0.4], [3, 0, 0.3], [4, 0, 0],\n"
         "             [0, 1, 0.2], [1, 1, 0.5], [2, 1, 0.63], [3, 1, 0.5], [4, 1, 0.2],\n"
         "             [0, 2, 0.3], [1, 2, 0.61], [2, 2, 0.7], [3, 2, 0.6], [4, 2, 0.3],\n"
         "             [0, 3, 0.2], [1, 3, 0.5], [2, 3, 0.6], [3, 3, 0.49], [4, 3, 0.2]]\n"
         "    columns: 5\n"
         "  roof: {fair-net: net, within: 2 cm, method: least-change}\n",
         "[SL section VII.3] [BT09] [OC15] [NW06]", "batten_fair_net",
         BAT_PARAMETERS(parameters), false,
         .also =
             "fairing of a mesh, fair surface through points, smoothing of a grid, bicubic spline, noisy scan, net of battens",
         .formula =
             "    Σ h_u³ ∫ |z″|² du + Σ h_v³ ∫ |z″|² dv → minimum over points |z_ij − y_ij| ≤ within;\n"
             "    least change: Σ |z_ij − y_ij|² / within² + λ Σ_a C(3, a) ∫∫ |∂³S / ∂u^a ∂v^(3−a)|² du dv → minimum,\n"
             "    σ II(T, T) ≥ 0 along sections, σ = ±1 with as many changes as they need",
         .promise =
             "No point moves farther than the bound; inflections are counted on the surface that is delivered."},
    .run = run_fair_net};
