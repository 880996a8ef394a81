/* The size of options: every public function that takes some checks it and respects it. */
#include "support/options.h"

#include <batten/batten.h>
#include <dirent.h>
#include <stdlib.h>

/* What the functions are given beside their options; it need not be enough to succeed. */
typedef struct {
    batten_curve *line, *plan;
    batten_surface *flat, *plane;
    batten_chain *chain;
    batten_body *body;
    batten_triangles *triangles;
    batten_model *model;
    batten_offset_table *table;
} stage;

static batten_curve *line_in(int dimension)
{
    const double points[] = {0, 0, 0, 1, 0, 0};
    const double two[] = {0, 0, 1, 0}, knots[] = {0, 0, 1, 1};
    batten_curve *curve = NULL;
    const batten_points row = {dimension, 2, dimension == 2 ? two : points};
    CHECK_OK(batten_curve_create(row, 1, NULL, knots, &curve));
    return curve;
}

static batten_surface *bilinear_in(int dimension)
{
    const double three[] = {0, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0},
                 two[] = {0, 0, 0, 1, 1, 0, 1, 1};
    const double knots[] = {0, 0, 1, 1};
    batten_surface *surface = NULL;
    const batten_axis axis = {1, 2, knots, false};
    CHECK_OK(batten_surface_create(dimension, &axis, &axis, dimension == 2 ? two : three, NULL,
                                   &surface));
    return surface;
}

static stage stage_set(void)
{
    stage s = {.line = line_in(3), .plan = line_in(2)};
    s.flat = bilinear_in(2);
    s.plane = bilinear_in(3);
    CHECK_OK(batten_model_create(1, &s.model));
    const batten_span span = {.kind = BATTEN_SPAN_ARC, .length = 1};
    const double corners[] = {0, 0, 1, 0, 0, 1};
    const batten_chain_parts parts = {.dimension = 2, .count = 1, .spans = &span};
    CHECK_OK(batten_chain_create(&parts, 0, &s.chain));
    CHECK_OK(batten_body_from_surface("plane", s.plane, 1e-6, &s.body));
    const batten_triangles_parts one = {
        .dimension = 2, .degree = 1, .count = 1, .points = corners};
    CHECK_OK(batten_triangles_create(&one, &s.triangles));
    const batten_table_point keel = {.line = -1};
    const batten_table_station station = {"0", 0, 1, &keel};
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 1, &station, &s.table));
    return s;
}

static void stage_clear(stage *s)
{
    batten_curve_unref(s->line);
    batten_curve_unref(s->plan);
    batten_surface_unref(s->flat);
    batten_surface_unref(s->plane);
    batten_model_unref(s->model);
    batten_chain_unref(s->chain);
    batten_body_unref(s->body);
    batten_triangles_unref(s->triangles);
    batten_offset_table_unref(s->table);
}

static const double dots[16], wrong = (double)NAN;
static double many[16];
static const batten_points none = {2, 0, dots};
static const batten_grid no_grid = {2, 0, 0, dots};
static const batten_lattice no_lattice;
static const batten_uv no_directions;
static const batten_uv_out no_uv;
static const batten_rows no_rows = {2, 0, (const int[]){0}, dots};

/* ---- one row for each function that takes options ---- */

/* clang-format off */
#define ENTRIES(ROW) \
    ROW(batten_curve_least_squares, batten_curve_least_squares, (none, o, NULL, NULL, &curve)) \
    ROW(batten_curve_smooth, batten_curve_smooth, (none, o, NULL, NULL, &curve)) \
    ROW(batten_curve_p_spline, batten_curve_smooth, (none, o, NULL, NULL, &curve)) \
    ROW(batten_curve_aerofoil, batten_curve_aerofoil, (none, o, NULL, &curve)) \
    ROW(batten_curve_within, batten_curve_within, (none, o, NULL, NULL, &curve)) \
    ROW(batten_chain_biarcs, batten_chain_biarcs, (none, o, NULL, NULL, &chain)) \
    ROW(batten_curve_biarcs, batten_chain_biarcs, (none, o, NULL, &curve)) \
    ROW(batten_arcs_from_curve, batten_arcs, (s->line, o, NULL, &chain)) \
    ROW(batten_arcs_from_points, batten_arcs, (none, o, NULL, NULL, &chain)) \
    ROW(batten_curve_conics, batten_curve_conics, (none, o, NULL, NULL, &curve)) \
    ROW(batten_chain_nonlinear, batten_chain_nonlinear, (none, o, NULL, NULL, NULL, &chain)) \
    ROW(batten_chain_mehlum, batten_chain_mehlum, (none, o, NULL, NULL, NULL, &chain)) \
    ROW(batten_curve_minimum_energy, batten_curve_minimum_energy, (none, o, NULL, NULL, &curve)) \
    ROW(batten_chain_spiro, batten_chain_spiro, (none, o, NULL, NULL, &chain)) \
    ROW(batten_curves_continuity, batten_curve_continuity, (s->line, BATTEN_CURVE_END, s->plan, BATTEN_CURVE_START, o, &join)) \
    ROW(batten_surface_interpolate, batten_surface_interpolate, (no_grid, o, NULL, no_uv, NULL, &surface)) \
    ROW(batten_surface_nu, batten_surface_nu, (no_grid, o, NULL, &surface)) \
    ROW(batten_surface_tension, batten_surface_tension, (no_grid, o, &surface)) \
    ROW(batten_surface_fit_grid, batten_surface_fit_grid, (no_grid, o, NULL, no_uv, NULL, &surface)) \
    ROW(batten_surface_smooth_grid, batten_surface_fit_grid, (no_grid, o, NULL, no_uv, NULL, &surface)) \
    ROW(batten_curve_fairness, batten_fairness, (s->line, none, o, &fairness)) \
    ROW(batten_chain_fairness, batten_fairness, (s->chain, none, o, &fairness)) \
    ROW(batten_curve_interpolate, batten_curve_interpolate, (none, o, NULL, &curve)) \
    ROW(batten_curve_weighted, batten_curve_weighted, (none, o, NULL, &curve)) \
    ROW(batten_curve_quadratic, batten_curve_quadratic, (none, o, NULL, &curve)) \
    ROW(batten_curve_constrained, batten_curve_constrained, (none, o, NULL, NULL, &curve)) \
    ROW(batten_chain_tension, batten_chain_tension, (none, o, NULL, &chain)) \
    ROW(batten_curve_rational_tension, batten_chain_tension, (none, o, NULL, &curve)) \
    ROW(batten_tangents, batten_tangents, (none, o, many, NULL, many, many)) \
    ROW(batten_curve_catmull_rom, batten_curve_catmull_rom, (none, o, NULL, NULL, &curve)) \
    ROW(batten_tangents_kochanek_bartels, batten_tangents_kochanek_bartels, (none, o, many, many, many)) \
    ROW(batten_curve_correct_tangents, batten_curve_correct_tangents, (s->line, o, NULL, NULL, &curve)) \
    ROW(batten_curve_cornered, batten_curve_cornered, (none, o, NULL, &curve)) \
    ROW(batten_curve_directed, batten_curve_directed, (none, o, NULL, NULL, &curve)) \
    ROW(batten_mesh_from_surface, batten_mesh, (s->flat, o, NULL, NULL, &mesh)) \
    ROW(batten_model_meshed, batten_mesh, (s->model, o, NULL, NULL, &model)) \
    ROW(batten_curve_offset, batten_curve_offset, (s->line, wrong, o, NULL, &curves)) \
    ROW(batten_surface_offset, batten_surface_offset, (s->plane, wrong, o, NULL, &surface)) \
    ROW(batten_deformation_create, batten_deformation, (&no_lattice, dots, o, NULL, &deformation)) \
    ROW(batten_surface_developable, batten_surface_developable, (s->line, s->plan, o, &strip)) \
    ROW(batten_surface_unroll, batten_surface_unroll, (s->flat, o, &unrolled)) \
    ROW(batten_fold_create, batten_fold_create, (s->line, o, &fold)) \
    ROW(batten_curve_schoenberg, batten_curve_schoenberg, (none, o, NULL, NULL, &curve)) \
    ROW(batten_curve_quasi_interpolate, batten_curve_schoenberg, (none, o, NULL, NULL, &curve)) \
    ROW(batten_triangulate, batten_triangulate, (none, o, &triangles)) \
    ROW(batten_surface_scattered, batten_surface_scattered, (dots, none, o, NULL, NULL, &surface)) \
    ROW(batten_surface_cloud, batten_surface_scattered, (&cloud, o, NULL, NULL, NULL, &surface)) \
    ROW(batten_triangles_scattered, batten_triangles_scattered, (none, dots, o, NULL, NULL, &patches)) \
    ROW(batten_surface_skin, batten_surface_skin, (no_curves, o, NULL, NULL, NULL, &surface)) \
    ROW(batten_surface_skin_procedural, batten_surface_skin, (no_curves, o, NULL, &surface)) \
    ROW(batten_surface_sweep, batten_surface_sweep, (no_curves, line, o, NULL, NULL, &surface)) \
    ROW(batten_surfaces_sweep, batten_surface_sweep, (no_curves, line, o, NULL, NULL, &surfaces)) \
    ROW(batten_surface_sweep_procedural, batten_surface_sweep, (no_curves, line, o, &surface)) \
    ROW(batten_surfaces_pipe, batten_surface_sweep, (1, line, o, NULL, NULL, &surfaces)) \
    ROW(batten_surface_two_rails, batten_surface_two_rails, (line, rails, o, NULL, NULL, &surface)) \
    ROW(batten_read_memory, batten_read, ("", 0, o, NULL, NULL, &model)) \
    ROW(batten_read_file, batten_read, ("there/is/no/such/file", o, NULL, NULL, &model)) \
    ROW(batten_write_memory, batten_write, (s->model, o, NULL, &data, &size)) \
    ROW(batten_write_prepare, batten_write, (s->model, o, NULL, &model)) \
    ROW(batten_write_file, batten_write, (s->model, "no.such", o, NULL)) \
    ROW(batten_write_gcode, batten_write_gcode, (s->model, o, NULL, &data, &size)) \
    ROW(batten_gcode_tool_path, batten_write_gcode, (s->model, o, NULL, &model)) \
    ROW(batten_surface_coons_grid, batten_surface_coons_network, (no_grid, o, no_uv, &surface)) \
    ROW(batten_surface_coons_network, batten_surface_coons_network, (&net, o, NULL, &surface)) \
    ROW(batten_surface_catmull_rom, batten_curve_catmull_rom, (no_grid, no_directions, along, NULL, NULL, &surface)) \
    ROW(batten_surface_gordon, batten_surface_gordon, (no_curves, no_curves, o, NULL, NULL, &surface)) \
    ROW(batten_surface_skin_rows, batten_surface_skin_rows, (no_rows, o, NULL, no_uv, NULL, &surface)) \
    ROW(batten_surface_coons, batten_surface_coons, (sides, o, NULL, &surface)) \
    ROW(batten_surface_fill, batten_surface_fill, (0, &side, o, NULL, &surface)) \
    ROW(batten_curve_continuity, batten_curve_continuity, (s->line, o, &joins)) \
    ROW(batten_curves_joins, batten_curve_continuity, (1, &line, o, NULL, &all_joins)) \
    ROW(batten_surfaces_joins, batten_curve_continuity, (1, &plane, o, NULL, &all_joins)) \
    ROW(batten_body_joins, batten_curve_continuity, (s->body, o, NULL, &all_joins)) \
    ROW(batten_arcs_from_chain, batten_arcs, (s->chain, o, NULL, &chain)) \
    ROW(batten_mesh_from_body, batten_mesh, (s->body, o, NULL, NULL, NULL, &mesh)) \
    ROW(batten_mesh_from_triangles, batten_mesh, (s->triangles, o, NULL, NULL, &mesh)) \
    ROW(batten_hull_create, batten_hull, (1, &plane, o, &hull))
/* clang-format on */

/* clang-format off */
#define OUTPUTS \
    const batten_curve *line = s->line; \
    const batten_surface *plane = s->plane; \
    const batten_curve *const rails[2] = {s->plan, s->plan}; \
    const batten_curve_row no_curves = {0, &line}; \
    const batten_curve_net net = {0, 0, dots, dots, &line, &line}; \
    const batten_cloud cloud = {{3, 0, dots}, s->plane}; \
    const batten_curve_catmull_rom_options *const along[2] = {given, given}; \
    const batten_ribbon side = {0}; \
    const batten_ribbon sides[4] = {{line, NULL, NULL}, {line, NULL, NULL}, {line, NULL, NULL}, {line, NULL, NULL}}; \
    batten_curve *curve = NULL; \
    batten_chain *chain = NULL; \
    batten_surface *surface = NULL; \
    batten_surfaces surfaces = {0}; \
    batten_mesh *mesh = NULL; \
    batten_hull *hull = NULL; \
    batten_model *model = NULL; \
    batten_triangles *patches = NULL; \
    batten_deformation *deformation = NULL; \
    batten_curves curves = {0}; \
    batten_continuities joins = {0}; \
    batten_continuity join = {0}; \
    batten_joins all_joins = {0}; \
    batten_fairness fairness = {0}; \
    batten_developable strip = {0}; \
    batten_unrolled unrolled = {0}; \
    batten_fold fold = {0}; \
    batten_plane_triangles triangles = {0}; \
    char *data = NULL; \
    size_t size = 0

/* Whatever a call made all the same. */
#define RELEASE_OUTPUTS \
    batten_joins_release(&all_joins); \
    (void)plane, (void)rails, (void)no_curves, (void)net, (void)cloud, (void)along, (void)side, (void)sides; \
    (void)join, (void)fairness, (void)size, (void)strip, (void)unrolled, (void)fold, (void)triangles; \
    batten_surfaces_release(&surfaces); \
    batten_curves_release(&curves); \
    batten_release(data); \
    batten_release(joins.at); \
    batten_curve_unref(curve); \
    batten_chain_unref(chain); \
    batten_surface_unref(surface); \
    batten_mesh_unref(mesh); \
    batten_hull_free(hull); \
    batten_triangles_unref(patches); \
    batten_deformation_unref(deformation); \
    batten_model_unref(model)
/* clang-format on */

#define ENTRY_FUNCTION(function, type, arguments)                            \
    static batten_status call_##function(const void *set, const void *given) \
    {                                                                        \
        const stage *s = set;                                                \
        const type##_options *o = given;                                     \
        (void)o;                                                             \
        OUTPUTS;                                                             \
        const batten_status status = function arguments;                     \
        RELEASE_OUTPUTS;                                                     \
        return status;                                                       \
    }                                                                        \
    static void default_##function(void *options)                            \
    {                                                                        \
        const type##_options defaults = type##_defaults();                   \
        memcpy(options, &defaults, sizeof defaults);                         \
    }
ENTRIES(ENTRY_FUNCTION)

/* ---- those whose options are named otherwise, or have no defaults without a number ---- */

/* The bound has no default: 0, which is refused, is what a struct without it gives. */
static void default_fair(void *options)
{
    const batten_fair_options defaults = batten_fair_defaults(0);
    memcpy(options, &defaults, sizeof defaults);
}

static void default_curve_fair(void *options)
{
    const batten_curve_fair_options defaults = batten_curve_fair_defaults(0);
    memcpy(options, &defaults, sizeof defaults);
}

static void default_net_fair(void *options)
{
    const batten_net_fair_options defaults = batten_net_fair_defaults(0);
    memcpy(options, &defaults, sizeof defaults);
}

static void default_selection(void *options)
{
    const batten_offset_table_selection everything = batten_offset_table_everything();
    memcpy(options, &everything, sizeof everything);
}

static void default_loft(void *options)
{
    const batten_loft_options defaults = batten_loft_defaults(0);
    memcpy(options, &defaults, sizeof defaults);
}

static void default_sheet(void *options)
{
    const batten_fill_sheet_options defaults = batten_fill_sheet_defaults();
    memcpy(options, &defaults, sizeof defaults);
}

static batten_status call_batten_surface_fill_sheet(const void *set, const void *options)
{
    const batten_ribbon side = {((const stage *)set)->line, NULL, NULL};
    batten_fill_sheet out = {0};
    return batten_surface_fill_sheet(0, &side, options, NULL, &out);
}

static batten_status call_batten_surface_loft(const void *set, const void *options)
{
    const stage *s = set;
    batten_surface *out = NULL;
    const batten_status status = batten_surface_loft(s->table, options, NULL, NULL, &out);
    batten_surface_unref(out);
    return status;
}

static batten_status call_batten_hull_loft(const void *set, const void *options)
{
    const stage *s = set;
    batten_surface *out = NULL;
    const batten_status status = batten_hull_loft(s->table, options, NULL, NULL, &out);
    batten_surface_unref(out);
    return status;
}

static batten_status call_batten_fair_points(const void *set, const void *options)
{
    (void)set;
    return batten_fair_points(none, NULL, options, NULL, NULL, many);
}

static batten_status call_batten_curve_fair(const void *set, const void *options)
{
    const stage *s = set;
    batten_curve *out = NULL;
    const batten_status status = batten_curve_fair(s->line, options, NULL, NULL, &out);
    batten_curve_unref(out);
    return status;
}

static batten_status call_batten_fair_net(const void *set, const void *options)
{
    double point[3] = {0};
    (void)set;
    return batten_fair_net((batten_grid){3, 1, 1, point}, options, NULL, NULL, point, NULL);
}

static batten_status call_batten_fair_offset_table(const void *set, const void *options)
{
    const stage *s = set;
    batten_offset_table *out = NULL;
    const batten_status status =
        batten_fair_offset_table(s->table, BATTEN_FAIR_STATIONS, options, NULL, NULL, &out);
    batten_offset_table_unref(out);
    return status;
}

static batten_status call_batten_offset_table_select(const void *set, const void *options)
{
    const stage *s = set;
    batten_offset_table *out = NULL;
    const batten_status status = batten_offset_table_select(s->table, options, &out);
    batten_offset_table_unref(out);
    return status;
}

#define ENTRY_ROW(function, type, arguments) \
    {#function, #type "_options", sizeof(type##_options), default_##function, call_##function},
static const options_taker takers[] = {
    ENTRIES(ENTRY_ROW){"batten_fair_points", "batten_fair_options", sizeof(batten_fair_options),
                       default_fair, call_batten_fair_points},
    {"batten_curve_fair", "batten_curve_fair_options", sizeof(batten_curve_fair_options),
     default_curve_fair, call_batten_curve_fair},
    {"batten_fair_net", "batten_net_fair_options", sizeof(batten_net_fair_options),
     default_net_fair, call_batten_fair_net},
    {"batten_surface_fill_sheet", "batten_fill_sheet_options",
     sizeof(batten_fill_sheet_options), default_sheet, call_batten_surface_fill_sheet},
    {"batten_surface_loft", "batten_loft_options", sizeof(batten_loft_options), default_loft,
     call_batten_surface_loft},
    {"batten_hull_loft", "batten_loft_options", sizeof(batten_loft_options), default_loft,
     call_batten_hull_loft},
    {"batten_fair_offset_table", "batten_fair_options", sizeof(batten_fair_options),
     default_fair, call_batten_fair_offset_table},
    {"batten_offset_table_select", "batten_offset_table_selection",
     sizeof(batten_offset_table_selection), default_selection,
     call_batten_offset_table_select}};

/* ---- the tests ---- */

TEST(a_size_that_nobody_set_or_that_is_longer_than_ours_is_refused)
{
    stage s = stage_set();
    check_wrong_sizes(COUNT(takers), takers, &s);
    stage_clear(&s);
}

TEST(a_shorter_struct_gives_what_the_defaults_give)
{
    stage s = stage_set();
    check_shorter_options(COUNT(takers), takers, &s);
    stage_clear(&s);
}

/* Those whose options have more to them than the rows above can say. */
TEST(sizes_of_options_inside_options_are_checked_too)
{
    stage s = stage_set();
    batten_limits limits = batten_limits_defaults();
    batten_read_options reading = batten_read_defaults();
    batten_model *model = NULL;
    limits.size = 0;
    reading.limits = &limits;
    CHECK_STATUS(batten_read_memory("0 0", 3, &reading, NULL, NULL, &model),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the size in a batten_limits is 0; it must be ");
    CHECK_STATUS(batten_read_file("there/is/no/such", &reading, NULL, NULL, &model),
                 BATTEN_BAD_ARGUMENT);
    CHECK(model == NULL);

    batten_surface_skin_options across = batten_surface_skin_defaults();
    batten_surface_skin_rows_options rows = batten_surface_skin_rows_defaults();
    batten_surface *surface = NULL;
    across.size++;
    rows.across = &across;
    CHECK_STATUS(batten_surface_skin_rows(no_rows, &rows, NULL, no_uv, NULL, &surface),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the size in a batten_surface_skin_options is");

    batten_write_options writing = batten_write_defaults();
    writing.size = SIZE_MAX;
    CHECK(!batten_write_choose("a.csv", s.model, &writing));
    CHECK(!writing.commas);
    batten_mesh_options triangles = batten_mesh_defaults();
    char *data = NULL;
    size_t size = 0;
    triangles.size = 7;
    writing = batten_write_defaults();
    writing.format = BATTEN_FORMAT_STL;
    writing.mesh = &triangles;
    CHECK_STATUS(batten_write_memory(s.model, &writing, NULL, &data, &size),
                 BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the size in a batten_mesh_options is 7;");

    const batten_surface *const both[2] = {s.plane, s.plane};
    batten_surface_blend_end ends[2] = {batten_surfaces_blend_defaults(BATTEN_EDGE_U0),
                                        batten_surfaces_blend_defaults(BATTEN_EDGE_U1)};
    ends[1].size = 1;
    CHECK_STATUS(batten_surfaces_blend(both, ends, 1, NULL, &surface), BATTEN_BAD_ARGUMENT);
    CHECK_MESSAGE("the size in a batten_surface_blend_end is 1;");
    CHECK(surface == NULL);

    stage_clear(&s);
}
