#include "support/test.h"

#include <batten/design.h>
#include <stdlib.h>
#include <string.h>

/* What the operations below work on. */
static const char common[] = "batten: 1\nfeatures:\n"
                             "  p: {points: [[0, 0], [1, 1], [2, 1], [3, 0]]}\n"
                             "  row: {points: [[0, 0, 1], [1, 1, 1], [2, 1, 1]]}\n"
                             "  c: {interpolate: p}\n"
                             "  l1: {line: [[0, 0], [1, 0]]}\n  l2: {line: [[1, 0], [2, 1]]}\n "
                             " l3: {line: [[5, 0], [6, 1]]}\n"
                             "  ring: {circle: 1}\n  ring2: {circle: 0.8, at: [0, 0, 2]}\n"
                             "  s: {extrude: l1, along: z}\n  s2: {move: s, by: [1, 0, 0]}\n"
                             "  t: {read: offsets.csv}\n";

static batten_status evaluate(const char *feature, batten_design **out)
{
    char text[2000];
    FILE *file = fopen(test_scratch("offsets.csv"), "w");
    CHECK(file != NULL);
    fputs("x_m,z_m,half_breadth_m\n", file);
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 5; k++)
            fprintf(file, "%d,%d,%d\n", i, k, k == 0 ? 0 : 1 + k);
    fclose(file);
    snprintf(text, sizeof text, "%s  a: %s\n", common, feature);
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("operations.yaml");
    batten_design *design = NULL;
    batten_status status = batten_design_parse(text, strlen(text), &options, NULL, &design);
    if (status == BATTEN_OK)
        status = batten_design_evaluate(design, "a", NULL, NULL);
    if (status == BATTEN_OK)
        *out = design;
    else
        batten_design_free(design);
    return status;
}

/* What an operation should make; nothing: it should refuse. */
typedef struct {
    const char *feature;
    int count;
    const char *name; /* of the last */
    batten_object_kind kind;
} promise;

static void check_promise(const promise *row)
{
    batten_design *design = NULL;
    batten_status status = evaluate(row->feature, &design);
    if (test_memory_failed(status, BATTEN_OK))
        status = evaluate(row->feature, &design);
    if (row->count == 0) {
        CHECK(status != BATTEN_OK && *batten_message());
        return;
    }
    if (status != BATTEN_OK)
        printf("%s: %s\n", row->feature, batten_message());
    CHECK_INT(status, BATTEN_OK);
    const batten_model *model = batten_design_result(design, "a")->value;
    CHECK_INT(batten_model_count(model), row->count);
    const batten_object *last = batten_model_object(model, row->count - 1);
    CHECK_INT(last->kind, row->kind);
    if (row->name)
        CHECK_TEXT(last->name, row->name);
    batten_design_free(design);
}

TEST(operations_make_the_objects_they_promise)
{
    static const promise rows[] = {
        {"{split: c, parameter: 1}", 2, "c 2", BATTEN_OBJECT_CURVE},
        {"{split: s, parameter: 0.5, direction: v}", 2, "s 2", BATTEN_OBJECT_SURFACE},
        {"{part: s, from: 0.2, to: 0.5}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{join: [l1, l2]}", 1, "a", BATTEN_OBJECT_CURVE},
        {"{join: [s, s2], direction: u}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{reverse: [s]}", 0, NULL, BATTEN_OBJECT_SURFACE},
        {"{reverse: s, direction: v}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{refine: s, knots: [0.5, 0.5], direction: v}", 0, NULL, BATTEN_OBJECT_SURFACE},
        {"{refine: s, knots: [0.25, 0.5], direction: v}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{elevate: s, by: 2, direction: v}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{reduce: c, degree: 2, within: 1}", 1, "a", BATTEN_OBJECT_CURVE},
        {"{curve-of: s, u: [0, 1], v: 0.5}", 3, "s v=0.5", BATTEN_OBJECT_CURVE},
        {"{conic: [[0, 0], [1, 1], [2, 0]], through: [1, 0.4]}", 1, "a", BATTEN_OBJECT_CURVE},
        {"{conic: [[2, 0], [1.4142135623730951, 1.4142135623730951], [0, 2], "
         "[-1.4142135623730951, "
         "1.4142135623730951], [-2, 0]]}",
         1, "a", BATTEN_OBJECT_CURVE},
        {"{collect: [l1, l1, l1]}", 3, "l1 (3)", BATTEN_OBJECT_CURVE},
        {"{select: t, names: offsets.csv}", 0, NULL, BATTEN_OBJECT_OFFSET_TABLE},
        {"{interpolate: t, each: line}", 5, NULL, BATTEN_OBJECT_CURVE},
        {"{interpolate: t, degree: 2}", 5, NULL, BATTEN_OBJECT_CURVE},
        {"{interpolate: p, periodic: yes}", 1, "a", BATTEN_OBJECT_CURVE},
        {"{interpolate: p, start: direction, start-vector: x, end: natural}", 1, "a",
         BATTEN_OBJECT_CURVE},
        {"{interpolate-grid: t, degree-u: 2, knots: averaged}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{interpolate-grid: [p, row]}", 0, NULL, BATTEN_OBJECT_SURFACE},
        {"{interpolate-grid: t, gaps: [7, 8, 13], weights: 2}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{fit-grid: t, points-u: 4, points-v: 4}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{fit-grid: t, method: smooth, penalty: differences}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{fit-grid: t, within: 1 cm}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{fit-grid: t, rms: 1 mm}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{fit-grid: [p, row]}", 0, NULL, BATTEN_OBJECT_SURFACE},
        {"{fit-scattered: t, rms: 1 cm}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{fit-scattered: t, within: 1 cm, corners: [[0, 0, 0], [4, 0, 0], [4, 5, 4], [0, 5, "
         "4]]}",
         1, "a", BATTEN_OBJECT_SURFACE},
        {"{fit-scattered: [p, row], as: function, lambda: 1e-3}", 1, "a",
         BATTEN_OBJECT_SURFACE},
        {"{fit-scattered: [p, row], method: multilevel, as: function, levels: 3}", 1, "a",
         BATTEN_OBJECT_SURFACE},
        {"{scattered-surface: [p, row]}", 1, "a", BATTEN_OBJECT_TRIANGLES},
        {"{scattered-surface: [p, row], method: powell-sabin, gradients: network, same: 1 cm}",
         1, "a", BATTEN_OBJECT_TRIANGLES},
        {"{scattered-surface: t, method: linear, triangles: data-dependent, sliver: 0}", 1, "a",
         BATTEN_OBJECT_TRIANGLES},
        {"{skin: [ring, ring2], spine: l2, scale: [1, 0.5], twist: [0, 10 deg], frames: fixed}",
         1, "a", BATTEN_OBJECT_SURFACE},
        {"{skin: [l1, l2, l3], parameters: uniform, degree: 2}", 1, "a", BATTEN_OBJECT_SURFACE},
        {"{fair: c, within: 10 cm, order: worst-first}", 1, "a", BATTEN_OBJECT_CURVE},
        {"{fair: t, within: 10 cm, families: stations}", 1, NULL, BATTEN_OBJECT_OFFSET_TABLE},
        {"{read: offsets.csv, unit: ft, scale: 2}", 1, NULL, BATTEN_OBJECT_OFFSET_TABLE},
        {"{read: offsets.csv, x: [0.5, 3.5], y: [0, 4], z: [0, 3], trim-centre: yes}", 1, NULL,
         BATTEN_OBJECT_OFFSET_TABLE},
    };
    for (int i = 0; i < COUNT(rows); i++)
        check_promise(&rows[i]);
}

TEST(operations_say_what_they_cannot_do)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{join: [l1, s]}", "curves and surfaces cannot be joined"},
        {"{join: [l1, l3]}", "a (join)"},
        {"{ruled: [l1, l2, l3]}", "between 2 curves, not 3"},
        {"{curve-of: s}", "'u' or 'v' must say"},
        {"{select: c, names: [q]}", "'c' has no object 'q'"},
        {"{skin: [l1, l2], twist: 3 deg}", "'twist' has 1 value for 2 sections"},
        {"{skin: [l1, l2], spine: s}", "curves are needed"},
        {"{skin: [l1, l2], spine: t}", "curves are needed"},
        {"{fair: s, within: 1 mm}", "without the points it was made from"},
        {"{fair: l1, within: 1 mm}", "without the points it was made from"},
        {"{move: t, by: x}", "is a table of offsets, which cannot be moved"},
        {"{read: offsets.csv, unit: furlong}", "not a known unit of length"},
        {"{read: offsets.csv, scale: 0}", "must be above 0"},
        {"{read: absent.csv}", "there is no such file"},
        {"{extrude: l1, along: origin}", "'along' is 0"},
        {"{revolve: l1, axis: origin}", "'axis' is 0"},
        {"{interpolate-grid: [p, row]}", "has 3 points, and the first row has 4"},
        {"{interpolate-grid: t, gaps: [4, 26]}", "gap 26: the points are counted 1 to 25"},
        {"{interpolate-grid: t, weights: [1, 2]}", "'weights' has 2 numbers for 25 points"},
        {"{fit-grid: t, rms: 1 mm, lambda: 1}", "either 'rms' or 'lambda'"},
        {"{fit-grid: t, within: 1 mm, method: smooth}", "is for least squares"},
        {"{fit-grid: t, points-u: 9}", "9 control points along u, and the grid has 5 lines"},
        {"{fit-scattered: l1}", "a (fit-scattered)"},
        {"{fit-scattered: t, corners: [[0, 0], [1, 0], [1, 1]]}",
         "'corners' has 3 points, not 4"},
        {"{fit-scattered: t, base: s, corners: [[0, 0], [1, 0], [1, 1], [0, 1]]}",
         "either 'base' or 'corners'"},
        {"{fit-scattered: t, as: function, base: s}", "has no base"},
        {"{fit-scattered: t, within: 1 mm, robust: yes}", "goes with none of"},
        {"{fit-scattered: t, within: 0}", "must be above 0"},
        {"{scattered-surface: l1}", "a (scattered-surface)"},
        {"{scattered-surface: p, sliver: 2}", "must be in [0, 0.5)"},
        {"{scattered-surface: [p, row], same: -1}", "must not be below 0"},
        {"{conic: [[0, 0], [1, 1], [2, 0], [3, 1], [4, 0, 1]]}", "in the plane z = 0"},
        {"{reduce: c, degree: 1, within: 1 mm}", "a (reduce)"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_status status = evaluate(rows[i].feature, &design);
        if (test_memory_failed(status, BATTEN_OK))
            status = evaluate(rows[i].feature, &design);
        CHECK(status != BATTEN_OK);
        CHECK_MESSAGE(rows[i].says);
    }
}

TEST(a_lines_plan_takes_its_stations_and_title)
{
    char text[2000];
    snprintf(text, sizeof text,
             "%s  st: {interpolate: t}\n  h: {skin: st}\noutputs:\n"
             "  a.svg: {lines-plan: h, station-at: [1, 2, 3], design-waterline: 2, title: A}\n"
             "  b.svg: {picture: h, azimuth: 20 deg, elevation: 10 deg, title: B}\n"
             "  c.step: {write: [h, st], title: C, within: 1 mm, format: step}\n",
             common);
    batten_design *design = NULL;
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("plan.yaml");
    batten_design *first = NULL;
    CHECK_OK(evaluate("{collect: p}", &first)); /* writes offsets.csv */
    batten_design_free(first);
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, &design));
    for (int i = 0; i < 3; i++) {
        char *data = NULL;
        size_t size;
        CHECK_OK(batten_design_output(design, i, NULL, NULL, &data, &size));
        CHECK(size > 200);
        batten_release(data);
    }
    batten_design_free(design);
}

TEST(a_lines_plan_draws_the_stations_of_its_data)
{
    char text[2000];
    snprintf(text, sizeof text,
             "%s  st: {interpolate: t}\n  h: {skin: st}\noutputs:\n"
             "  own.png: {lines-plan: h, data: t}\n"
             "  same.png: {lines-plan: h, data: t, station-at: [0, 1, 2, 3, 4]}\n"
             "  other.png: {lines-plan: h, data: t, stations: 0.5}\n",
             common);
    batten_design *design = NULL, *first = NULL;
    batten_design_options options = batten_design_defaults();
    options.file_name = test_scratch("stations.yaml");
    CHECK_OK(evaluate("{collect: p}", &first)); /* writes offsets.csv: stations 0 to 4 */
    batten_design_free(first);
    CHECK_OK(batten_design_parse(text, strlen(text), &options, NULL, &design));
    char *data[3] = {NULL, NULL, NULL};
    size_t size[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++)
        CHECK_OK(batten_design_output(design, i, NULL, NULL, &data[i], &size[i]));
    CHECK(size[0] == size[1] && memcmp(data[0], data[1], size[0]) == 0);
    CHECK(size[0] != size[2] || memcmp(data[0], data[2], size[0]) != 0);
    for (int i = 0; i < 3; i++)
        batten_release(data[i]);
    batten_design_free(design);
}
