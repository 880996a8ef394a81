/* A check made by hand: features and objects with chosen figures, for the forms of its report. */
#ifndef TESTS_DESIGN_OUTPUTS_MADE_CHECK_H
#define TESTS_DESIGN_OUTPUTS_MADE_CHECK_H
#include "design/outputs/fairness.h"
#include "support/test.h"

#include <math.h>

/* In inches; the features are evaluated in the order 2, 1, 3 ..., and the last is not upstream. */
enum { MADE_FEATURES = 7, MADE_OBJECTS = 4, MADE_JOINS = 5 };

typedef struct {
    bat_document document;
    bat_run run;
    bat_result results[MADE_FEATURES];
    bat_checked objects[MADE_OBJECTS];
    bat_join joins[MADE_JOINS];
    batten_offset_table *table;
    bat_check check;
} made_check;

static const batten_fair_report made_fairing = {
    .before = {.excess_inflections = 7, .energy = 12345.678},
    .after = {.excess_inflections = 2, .energy = 0.5},
    .max_move = 0.0123456,
    .rms_move = 0.004,
    .moved_count = 3,
    .worst_set = 1,
    .worst_index = 4,
    .suspect_count = 1};
static const batten_fair_report made_net = {.before = {.energy = 3},
                                            .after = {.energy = 0},
                                            .max_move = 2,
                                            .moved_count = 1,
                                            .control_points = true};
static const batten_surface_skin_report made_skin = {.error = 0.25,
                                                     .worst_section = 3,
                                                     .exact_knot_count = 12,
                                                     .knot_count = 1,
                                                     .span_ratio = 0.125,
                                                     .normal_jump = 0.375,
                                                     .speed_jump = 0.0625,
                                                     .crease = 0.75,
                                                     .cure = BATTEN_CURE_RESCALED,
                                                     .reversed_count = 2,
                                                     .turned_count = 4,
                                                     .crossing_count = 5,
                                                     .disorder_count = 6};

static batten_loft_correction made_corrections[] = {
    {0, 0, {1, 2, 3}, {1, 2.5, 3}, 0.5, BATTEN_LOFT_NOISE},
    {0, 1, {1, 4, 6}, {1, 4, 5.6}, 0.4, BATTEN_LOFT_BOUND},
    {1, 0, {9, 2, 3}, {8.7, 2, 3}, 0.3, BATTEN_LOFT_SUSPECT},
    {1, 1, {9, 4, 6}, {9, 4.2, 6}, 0.2, BATTEN_LOFT_NOISE},
    {1, 2, {9, 5, 8}, {9, 5.1, 8}, 0.1, BATTEN_LOFT_NOISE},
    {0, 2, {1, 5, 8}, {1, 5.05, 8}, 0.05, BATTEN_LOFT_NOISE}};

static batten_loft_warp made_warps[] = {{0, 0.125, 0.25, 0.5, {1, 2}},
                                        {2, 0.0625, 0.375, 0.75, {3, 4}}};

static const batten_loft_report made_loft = {.warp_count = COUNT(made_warps),
                                             .warps = made_warps,
                                             .cut_count = 30,
                                             .cuts_in_excess = 2,
                                             .excess_inflections = 4,
                                             .height = 0.001,
                                             .max_move = 0.5,
                                             .rms_move = 0.1,
                                             .worst_station = 1,
                                             .worst_index = 2,
                                             .correction_count = COUNT(made_corrections),
                                             .corrections = made_corrections,
                                             .faired_error = 0.03125,
                                             .rounds = 8};

/* Of the first of these a figure of energy is known, of the second not. */
static const batten_fairness made_fairness[] = {{.inflections = 1,
                                                 .curvature_extrema = 2,
                                                 .jumps = 0.5,
                                                 .energy = 1.2345678,
                                                 .variation = 7.5,
                                                 .max_curvature = 0.0123456,
                                                 .fair = true,
                                                 .energy_error = 1e-9,
                                                 .variation_error = 2e-9},
                                                {.inflections = 3,
                                                 .excess_inflections = 2,
                                                 .curvature_extrema = 5,
                                                 .energy = HUGE_VAL,
                                                 .variation = HUGE_VAL,
                                                 .max_curvature = HUGE_VAL,
                                                 .corners = 1,
                                                 .curvature_jumps = 2,
                                                 .halts = 3,
                                                 .cusps = 4,
                                                 .unbounded = 6,
                                                 .largest_turn = 1.5,
                                                 .largest_jump = 0.25}};

static bat_section made_sections[] = {
    {"station", "S1", 1, true, {.max_curvature = 0.5}, 0, 9, 0, 0},
    {"station", "S\"2", 2.5, true, {.inflections = 3, .max_curvature = 4}, 3, 9, 1, 2},
    {"station", "S3", 3, false, {.fair = false}, 0, 9, 0, 0},
    {"waterline", "W1", 0.5, true, {.max_curvature = 0.25}, 1, 9, 0, 1},
    {"buttock", "B1", 4, false, {.fair = false}, 0, 2, 0, 0}};

static const batten_object made_curves[] = {{.name = "sheer", .kind = BATTEN_OBJECT_CURVE},
                                            {.name = "ch\"ine", .kind = BATTEN_OBJECT_CURVE}};
static const batten_object made_surfaces[] = {{.name = "bottom", .kind = BATTEN_OBJECT_SURFACE},
                                              {.name = "side", .kind = BATTEN_OBJECT_SURFACE}};

static const bat_checked made_objects[MADE_OBJECTS] = {
    {.object = &made_curves[0],
     .has_fairness = true,
     .knot_count = 1,
     .parametric = 2,
     .geometric = 3,
     .distance_count = 1,
     .distances =
         (bat_data_distance[]){{"ducks", false, 1, 0.00123456, 0.00123456, {1, 0.123456, 0}, 0}}},
    {.object = &made_curves[1], .has_fairness = true},
    {.object = &made_surfaces[0],
     .is_hull = true,
     .fold = {true, 0, 0, {1, 2, 3.14159}},
     .distance_count = 2,
     .distances = (bat_data_distance[]){{"ducks", false, 9, 0.5, 0.25, {4, 5, 6}, 3},
                                        {"faired", true, 9, 123456, 0, {7, 8, 9}, 0}},
     .section_count = COUNT(made_sections),
     .sections = made_sections,
     .edge_count = 2,
     .edges = {{"v low", 0.000123456, true}, {"v high", 7, false}}},
    {.object = &made_surfaces[1]}};

/* Of curves; of surfaces: whole, along a part of the first and of the second, at a pole. */
static const bat_join made_joins[MADE_JOINS] = {{{{0, 1},
                                                  {1, 0},
                                                  -1,
                                                  -1,
                                                  0,
                                                  1,
                                                  {0.5, {1, 2, 3}},
                                                  {NAN, {0, 0, 0}},
                                                  {NAN, {0, 0, 0}},
                                                  {NAN, {0, 0, 0}},
                                                  NAN,
                                                  NAN},
                                                 {-1, -1},
                                                 false,
                                                 false},
                                                {{{0, 1},
                                                  {0, 1},
                                                  -1,
                                                  -1,
                                                  2,
                                                  3,
                                                  {0, {4, 5, 6}},
                                                  {0.5, {0, 0, 0}},
                                                  {NAN, {0, 0, 0}},
                                                  {NAN, {0, 0, 0}},
                                                  NAN,
                                                  8},
                                                 {-1, -1},
                                                 false,
                                                 false},
                                                {{{2, 3},
                                                  {3, 2},
                                                  -1,
                                                  -1,
                                                  -1,
                                                  0,
                                                  {0, {0, 0, 0}},
                                                  {0.25, {1, 0, 0}},
                                                  {0.125, {2, 0, 0}},
                                                  {0.75, {3, 0, 0}},
                                                  16,
                                                  32},
                                                 {-1, -1},
                                                 true,
                                                 false},
                                                {{{2, 3},
                                                  {0, 1},
                                                  0,
                                                  -1,
                                                  -1,
                                                  1,
                                                  {0, {7, 0, 0}},
                                                  {0.25, {8, 0, 0}},
                                                  {NAN, {0, 0, 0}},
                                                  {NAN, {0, 0, 0}},
                                                  NAN,
                                                  NAN},
                                                 {-1, -1},
                                                 false,
                                                 false},
                                                {{{2, 3},
                                                  {1, 0},
                                                  1,
                                                  -1,
                                                  -1,
                                                  2,
                                                  {0.0625, {4, 0, 0}},
                                                  {0.75, {5, 0, 0}},
                                                  {0.5, {6, 7, 8}},
                                                  {0.875, {9, 1, 2}},
                                                  64,
                                                  128},
                                                 {-1, -1},
                                                 false,
                                                 false}};

static void make_table(batten_offset_table **out)
{
    static const batten_table_line lines[] = {{"sheer", false, 0}};
    static const batten_table_point aft[] = {{1, 2, 3, -1}, {1, 4, 6, -1}, {1, 5, 8, 0}};
    static const batten_table_point fore[] = {{9, 2, 3, -1}, {9, 4, 6, -1}, {9, 5, 8, 0}};
    static const batten_table_station stations[] = {{"1", 1, 3, aft}, {"stem", 9, 3, fore}};
    CHECK_OK(batten_offset_table_create(0.0254, 1, lines, 2, stations, out));
}

static void make_results(made_check *made, batten_fair_report *fairing, batten_fair_report *net,
                         batten_surface_skin_report *skin, batten_loft_report *loft)
{
    static const char *const names[MADE_FEATURES][2] = {
        {"faired", "fair"}, {"ducks", "points"}, {"net", "fair"},     {"skin", "skin"},
        {"near", "arcs"},   {"hull", "loft"},    {"unused", "points"}};
    for (int i = 0; i < MADE_FEATURES; i++) {
        made->results[i].shown.name = names[i][0];
        made->results[i].shown.operation = names[i][1];
    }
    made->results[0].shown.fairing = fairing;
    made->results[2].shown.fairing = net;
    made->results[3].shown.skin = skin;
    made->results[4].shown.has_error = made->results[5].shown.has_error = true;
    made->results[4].shown.error_max = made->results[5].shown.error_max = 0.75;
    made->results[4].shown.error_rms = made->results[5].shown.error_rms = 0.5;
    made->results[5].shown.loft = loft;
}

/* Release its table. */
static void make_check(made_check *made)
{
    static bool upstream[MADE_FEATURES] = {true, true, true, true, true, true, false};
    static int order[MADE_FEATURES] = {1, 0, 2, 3, 4, 5, 6};
    static batten_fair_report fairing, net;
    static batten_surface_skin_report skin;
    static batten_loft_report loft;
    *made = (made_check){.document = {.unit_metres = 0.0254, .title = "A hull"}};
    make_table(&made->table);
    fairing = made_fairing, net = made_net, skin = made_skin, loft = made_loft;
    loft.faired = made->table;
    make_results(made, &fairing, &net, &skin, &loft);
    made->document.feature_count = MADE_FEATURES;
    made->document.order = order;
    made->run = (bat_run){.document = &made->document, .results = made->results};
    memcpy(made->objects, made_objects, sizeof made_objects);
    memcpy(made->joins, made_joins, sizeof made_joins);
    made->objects[0].fairness = made_fairness[0];
    made->objects[1].fairness = made_fairness[1];
    made->check = (bat_check){.run = &made->run,
                              .upstream = upstream,
                              .within = HUGE_VAL,
                              .object_count = MADE_OBJECTS,
                              .objects = made->objects,
                              .join_count = MADE_JOINS,
                              .joins = made->joins,
                              .ok = true,
                              .judged_count = 1};
}

/* What one of the forms says of the check. */
static batten_status try_form(const bat_check *check,
                              void (*write)(const bat_check *check, batten_text *out),
                              char **data)
{
    batten_text text = BATTEN_TEXT;
    size_t size;
    write(check, &text);
    const batten_status status = batten_text_take(&text, data, &size);
    batten_text_free(&text);
    return status;
}

static char *write_check(const bat_check *check,
                         void (*write)(const bat_check *check, batten_text *out))
{
    char *data = NULL;
    CHECK_OK(try_form(check, write, &data));
    return data;
}

#endif
