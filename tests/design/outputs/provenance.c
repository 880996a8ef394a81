#include "design/expect.h"
#include "design/outputs/checked.h"

/* Which points a shape is measured against: those given, those moved by fairing, none where an operation displaces. */

static const char curves[] =
    "  ducks: {points: [[0, 0], [1, 0.1], [2, 0.4], [3, 0.8], [4, 1.7], [5, 2.4]]}\n"
    "  c1: {interpolate: ducks}\n"
    "  f1: {fair: c1, within: 0.02}\n"
    "  lifted: {move: f1, by: [0, 0, 1]}\n"
    "  skin: {skin: [f1, lifted]}\n"
    "  bent: {deform: skin, counts: 2, move: [2, 2, 2, 0, 0, 0.5]}\n"
    "  sheet: {bilinear: [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]}\n"
    "  unused: {points: [[7, 7], [8, 8]]}\n"
    "  edge: {line: [[0, 0], [1, 0]]}\n";

static const expect_row rows[] = {
    {"k.json: {check: c1}", BATTEN_OK,
     "\"distances\": [{\"from\": \"c1\", \"faired\": false, \"points\": 6, "
     "|!\"faired\": true|!unused"},
    /* Those given may be as far as fairing may move them; those moved lie on the surface. */
    {"k.json: {check: skin, within: 0.02}", BATTEN_OK,
     "\"ok\": true|\"distances\": [{\"from\": \"ducks\", \"faired\": false, \"points\": 6, \"max\": "
     "0.01|}, {\"from\": \"f1\", \"faired\": true, \"points\": 6, |!unused"},
    {"k.json: {check: skin, within: 0.005}", BATTEN_OK, "\"ok\": false"},
    {"k.txt: {check: skin, within: 0.005}", BATTEN_OK,
     "distance from the 6 points given, 'ducks'|distance from the 6 points after fairing, "
     "'f1'|the points given lie farther than 0.005 m"},
    {"k.json: {check: bent}", BATTEN_OK, "\"distances\": []"},
    {"k.json: {check: sheet}", BATTEN_OK, "\"distances\": []|\"fair\": null"},
    {"k.json: {check: edge}", BATTEN_OK, "\"type\": \"curve\"|!\"distances\""},
};

TEST(shapes_are_measured_against_the_points_that_they_come_from)
{
    EXPECT_OUTPUTS(curves, rows);
}

/* ---- points that are cut off ---- */

static const char parts[] =
    "  ducks: {points: [[0, 0], [1, 0.2], [2, 0.31], [3, 0.29], [4, 0]]}\n"
    "  above: {points: [[0, 0, 1], [1, 0.2, 1], [2, 0.31, 1], [3, 0.29, 1], [4, 0, 1]]}\n"
    "  sheer: {interpolate: ducks}\n"
    "  rail: {interpolate: above}\n"
    "  fore: {part: sheer, from: 0, to: 2.5}\n"
    "  bow: {part: fore, from: 0, to: 1.5}\n"
    "  halves: {split: sheer, parameter: 2.5}\n"
    "  aft: {select: halves, names: [sheer 2]}\n"
    "  middle: {trim: sheer, between: [1.5, 2.5]}\n"
    "  short: {part: sheer, from: 1.4, to: 1.5}\n"
    "  both: {skin: [bow, rail]}\n"
    "  band: {skin: [bow, sheer]}\n";

static const expect_row cut_rows[] = {
    {"k.json: {check: fore, within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"distances\": [{\"from\": \"ducks\", \"faired\": false, \"points\": 3, "
     "|\"left_out\": 2}"},
    {"k.json: {check: bow, within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"points\": 2, |\"left_out\": 3}"},
    {"k.json: {check: middle, within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"points\": 1, |\"left_out\": 4}"},
    {"k.json: {check: halves, within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"points\": 5, |\"left_out\": 0}"},
    {"k.json: {check: aft, within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"points\": 2, |\"left_out\": 3}"},
    {"k.json: {check: [aft, bow], within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"points\": 4, |\"left_out\": 1}"},
    {"k.json: {check: both, within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"from\": \"ducks\", \"faired\": false, \"points\": 2, |\"left_out\": 3}"
     "|\"from\": \"above\", \"faired\": false, \"points\": 5, |\"left_out\": 0}"},
    /* Half of its points come by two ways, all of them by one. */
    {"k.json: {check: band, within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"points\": 5, |\"left_out\": 0}"},
    {"k.json: {check: short, within: 1e-6}", BATTEN_OK,
     "\"ok\": true|\"points\": 0, \"max\": null, \"rms\": null, \"at\": null, "
     "\"left_out\": 5}"},
    {"k.txt: {check: short, within: 1e-6}", BATTEN_OK,
     "all 5 points given, 'ducks', lie beyond the shape\n|there are no points to measure"},
    {"k.txt: {check: fore}", BATTEN_OK, "3 points given, 'ducks'|; 2 beyond the shape left out\n"},
};

TEST(points_on_what_was_cut_off_are_left_out_and_counted)
{
    EXPECT_OUTPUTS(parts, cut_rows);
}

/* ---- points where there is no hull ---- */

/* Two stations of four points, from the keel up: the first two of each say that no hull is there, or that it begins. */
static void put_bow(checked_design *d, batten_offset_table **table)
{
    static const batten_table_point points[2][4] = {
        {{0, 0, 0, -1}, {0, 0, 1, -1}, {0, 1, 2, -1}, {0, 1, 3, -1}},
        {{1, 0, 0, -1}, {1, 0, 1, -1}, {1, 1.25, 2, -1}, {1, 1, 3, -1}}};
    static const batten_table_station stations[] = {{"1", 0, 4, points[0]},
                                                    {"2", 1, 4, points[1]}};
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 2, stations, table));
    checked_put(d, "table",
                &(batten_object){.name = "table",
                                 .kind = BATTEN_OBJECT_OFFSET_TABLE,
                                 .offset_table = *table});
}

TEST(offsets_that_say_that_there_is_no_hull_are_not_measured)
{
    /* The hull has two panels: on one lies the third point of each station but that which moved. */
    static batten_loft_correction moved = {.station = 1, .index = 2};
    static batten_loft_report loft = {
        .panel_count = 1, .trimmed_count = 2, .correction_count = 1, .corrections = &moved};
    checked_design d;
    batten_surface *lower = NULL, *upper = NULL;
    checked_open("  table: {points: [[0, 0, 0]]}\n  hull: {loft: table, within: 0.3}\n", "hull",
                 &d);
    checked_result(&d, "hull")->shown.loft = &loft;
    put_bow(&d, &loft.faired);
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 0, 1}, (batten_vec3){1, 0, 1},
                                     (batten_vec3){0, 1, 2}, (batten_vec3){1, 1, 2}, &lower));
    checked_put_surface(&d, "hull", lower);
    CHECK_OK(batten_surface_bilinear((batten_vec3){0, 1, 2}, (batten_vec3){1, 1, 2},
                                     (batten_vec3){0, 1, 3}, (batten_vec3){1, 1, 3}, &upper));
    checked_put_surface(&d, "hull", upper);
    const bat_checked *hull = checked_run(&d, 0.3);
    CHECK_INT(hull->distance_count, 1);
    CHECK_INT(hull->distances[0].count, 6);
    CHECK_INT(hull->distances[0].left_out, 2);
    CHECK_NEAR(hull->distances[0].max, 0.25 * sqrt(0.5), 0.08);
    CHECK(d.check.ok);
    batten_offset_table_unref(loft.faired);
    checked_close(&d);
}

/* ---- where each object comes from ---- */

static const double row[] = {0, 0, 0, 1, 0.5, 0, 2, 0.25, 0};

static void put_row(checked_design *d, const char *feature)
{
    checked_put_points(d, feature, 3, row);
}

/* Written in reverse, so that the order is that of evaluation. */
static const char chain[] = "  sheet: {skin: [second, first], within: 8 m}\n"
                            "  aside: {skin: [second, first], spine: rail}\n"
                            "  second: {fair: first, within: 0.005}\n"
                            "  first: {fair: curve, within: 0.02}\n"
                            "  curve: {interpolate: ducks}\n"
                            "  moved: {move: ducks, by: x}\n"
                            "  ducks: {points: [[0, 0, 0]]}\n"
                            "  rail: {line: [[0, 0, 0], [0, 0, 1]]}\n"
                            "  unused: {points: [[0, 0, 0]]}\n";

static void open_chain(const char *what, checked_design *d)
{
    static const char *const faired[] = {"first", "second"};
    checked_open(chain, what, d);
    put_row(d, "unused");
    put_row(d, "ducks");
    put_row(d, "moved");
    for (int i = 0; i < COUNT(faired); i++) {
        put_row(d, faired[i]);
        checked_result(d, faired[i])->shown.has_moves = true;
    }
    checked_put_line(d, "sheet", (batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0});
    checked_put_line(d, "aside", (batten_vec3){5, 0, 0}, (batten_vec3){6, 0, 0});
}

/* Those given come first, the others are those after fairing. */
static void check_data(const checked_design *d, int object, int count, const char *const *names,
                       int given)
{
    const bat_data_roots *data = &d->check.objects[object].data;
    CHECK_INT(data->count, count);
    for (int i = 0; i < count && count == data->count; i++) {
        CHECK_INT(data->at[i].feature, bat_document_feature(&d->document, names[i]));
        CHECK(data->at[i].is_faired == (i >= given));
        CHECK(data->at[i].is_last == (i >= given || count == given));
    }
}

static void check_origin(const checked_design *d, int object, const char *given,
                         const char *faired, double moved_by)
{
    const char *const names[] = {given ? given : faired, faired};
    check_data(d, object, (given != NULL) + (faired != NULL), names, given != NULL);
    CHECK_NEAR(d->check.objects[object].moved_by, moved_by, 1e-15);
}

TEST(data_are_the_first_points_upstream_and_the_last_made_fair_within_the_sum_of_the_bounds)
{
    checked_design d;
    open_chain("sheet", &d);
    checked_run(&d, HUGE_VAL);
    check_data(&d, 0, 3, (const char *[]){"ducks", "first", "second"}, 1);
    CHECK_NEAR(d.check.objects[0].moved_by, 0.025, 1e-15);
    CHECK(!d.check.objects[0].is_hull);
    CHECK_INT(d.check.objects[0].panels_of, -1);
    for (int i = 0; i < d.document.feature_count; i++) {
        const char *name = d.document.features[i].name;
        CHECK(d.check.upstream[i] ==
              (strcmp(name, "aside") != 0 && strcmp(name, "moved") != 0 &&
               strcmp(name, "rail") != 0 && strcmp(name, "unused") != 0));
    }
    checked_close(&d);
}

TEST(what_lies_along_a_spine_has_no_data)
{
    checked_design d;
    open_chain("aside", &d);
    checked_run(&d, HUGE_VAL);
    check_origin(&d, 0, NULL, NULL, 0.025);
    checked_close(&d);
}

TEST(each_feature_that_is_checked_has_its_own_data)
{
    checked_design d;
    open_chain("[curve, moved, unused, first]", &d);
    for (int i = 0; i < 2; i++)
        checked_put_line(&d, "curve", (batten_vec3){10, i, 0}, (batten_vec3){11, i, 0});
    checked_run(&d, HUGE_VAL);
    CHECK_INT(d.check.object_count, 5);
    check_origin(&d, 0, "ducks", NULL, 0);
    check_origin(&d, 1, "ducks", NULL, 0);
    check_origin(&d, 2, "moved", NULL, 0);
    check_origin(&d, 3, "unused", NULL, 0);
    check_origin(&d, 4, "ducks", "first", 0.02);
    checked_close(&d);
}

static const char lofted[] = "  table: {points: [[0, 0, 0]]}\n"
                             "  curves: {interpolate: table}\n"
                             "  hull: {loft: table, within: 3 mm}\n"
                             "  other: {loft: table, within: 5 mm}\n"
                             "  shifted: {swap: hull}\n"
                             "  rows: {interpolate: table}\n";

TEST(what_comes_of_a_table_is_a_hull_and_panels_are_those_of_a_lofting_with_several)
{
    static const batten_table_point point = {0, 1, 2, -1};
    static const batten_table_station station = {"0", 0, 1, &point};
    static batten_loft_report one = {.panel_count = 1}, two = {.panel_count = 2};
    checked_design d;
    batten_offset_table *table = NULL;
    CHECK_OK(batten_offset_table_create(1, 0, NULL, 1, &station, &table));
    checked_open(lofted, "[shifted, rows, other]", &d);
    checked_put(&d, "table",
                &(batten_object){.kind = BATTEN_OBJECT_OFFSET_TABLE, .offset_table = table});
    batten_offset_table_unref(table);
    checked_result(&d, "hull")->shown.loft = &two;
    checked_result(&d, "other")->shown.loft = &one;
    checked_put_line(&d, "shifted", (batten_vec3){0, 0, 0}, (batten_vec3){1, 0, 0});
    checked_put_line(&d, "rows", (batten_vec3){0, 5, 0}, (batten_vec3){1, 5, 0});
    checked_put_line(&d, "other", (batten_vec3){0, 9, 0}, (batten_vec3){1, 9, 0});
    checked_run(&d, HUGE_VAL);
    check_origin(&d, 0, "table", NULL, 0.003);
    check_origin(&d, 1, "table", NULL, 0);
    check_origin(&d, 2, "table", NULL, 0.005);
    CHECK(d.check.objects[0].is_hull && d.check.objects[1].is_hull);
    CHECK_INT(d.check.objects[0].panels_of, bat_document_feature(&d.document, "hull"));
    CHECK_INT(d.check.objects[1].panels_of, -1);
    CHECK_INT(d.check.objects[2].panels_of, -1);
    checked_close(&d);
}

/* ---- rows before fairing ---- */

/* Does the row [2][3] come from the given one, in the plane of x and z, within this bound? */
static bool is_taken(const checked_design *d, int count, const double *faired)
{
    double *points = NULL, bound = -1;
    CHECK_OK(
        bat_check_given_row(&d->check, d->check.objects, count, faired, 1, &points, &bound));
    const bool found = bound > 0;
    CHECK_NEAR(bound, found ? 0.025 : 0, 1e-15);
    const double *from = found ? row : faired;
    for (int i = 0; i < count; i++)
        CHECK(points[2 * i] == from[3 * i] && points[2 * i + 1] == from[3 * i + 2]);
    bat_release(points);
    return found;
}

TEST(a_row_is_taken_for_one_given_whose_points_are_all_within_the_bounds_of_fairing)
{
    checked_design d;
    open_chain("[sheet, moved]", &d);
    checked_run(&d, HUGE_VAL);
    CHECK(is_taken(&d, 3, (double[]){0, 0.025, 0, 1, 0.5, 0, 2, 0.25, 0}));
    CHECK(is_taken(&d, 3, (double[]){0, 0, 0, 1, 0.5, 0, 2.015, 0.25, -0.02}));
    CHECK(!is_taken(&d, 3, (double[]){0, 0.02501, 0, 1, 0.5, 0, 2, 0.25, 0}));
    CHECK(!is_taken(&d, 3, (double[]){0, 0, 0, 1, 0.5, 0, 2.02, 0.25, 0.02}));
    CHECK(!is_taken(&d, 2, row));
    d.check.objects[0].data.count = 1; /* only those given */
    CHECK(!is_taken(&d, 3, row));
    checked_close(&d);
}

/* Points that lie on their shapes, far from it, and at places that are no data. */
static const char several[] =
    "  four: {points: [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 1], [2, 1, 0]], "
    "columns: 3}\n"
    "  low: {points: [[0, 0], [1, 0.1], [2, 0.4], [3, 0.8]]}\n"
    "  high: {points: [[0, 0, 2], [1, 0.3, 2], [2, 0.6, 2], [3, 0.8, 2], [4, 1, 2]]}\n"
    "  cl: {interpolate: low}\n  ch: {interpolate: high}\n"
    "  loose: {least-squares: high, points: 4}\n"
    "  both: {skin: [cl, ch]}\n"
    "  near: {skin: [cl, loose]}\n"
    "  polygon: {bezier: low}\n"
    "  mixed: {skin: [polygon, ch]}\n"
    "  net: {bezier-surface: four}\n"
    "  lifted: {move: cl, by: [0, 0, 5]}\n"
    "  sheet: {extrude: lifted, along: [0, 0, 1]}\n"
    "  image: {mirror: cl, keep: no}\n"
    "  halves: {mirror: cl}\n"
    "  other: {extrude: image, along: [0, 0, 1]}\n"
    "  twins: {extrude: halves, along: [0, 0, 1]}\n"
    "  shell: {offset: both, by: 0.05}\n"
    "  faired: {fair: ch, within: 0.02}\n"
    "  raised: {move: faired, by: [0, 0, 1]}\n"
    "  pair: {skin: [faired, raised]}\n"
    "  top: {skin: [raised, lifted]}\n"
    "  way: {points: [[0, 0, 0], [0, 1, 0.5], [0, 2, 3]]}\n  rail: {interpolate: way}\n"
    "  slid: {translational: cl, path: rail}\n"
    "  tube: {pipe: cl, radius: 0.1}\n";

static const expect_row several_rows[] = {
    {"k.json: {check: both, within: 1e-9}", BATTEN_OK,
     "\"ok\": true|\"from\": \"low\", \"faired\": false, \"points\": 4|\"from\": \"high\", "
     "\"faired\": false, \"points\": 5|!\"from\": \"c"},
    /* The second feature's points are not met: the first one's do not hide that. */
    {"k.json: {check: near, within: 1e-9}", BATTEN_OK, "\"ok\": false"},
    {"k.json: {check: near, within: 0.2}", BATTEN_OK, "\"ok\": true"},
    {"k.json: {check: polygon, within: 1e-9}", BATTEN_OK, "\"ok\": true|!\"distances\""},
    {"k.json: {check: mixed, within: 1e-9}", BATTEN_OK,
     "\"ok\": true|\"from\": \"high\"|!\"from\": \"low\""},
    {"k.json: {check: net, within: 1e-9}", BATTEN_OK, "\"ok\": true|\"distances\": []"},
    {"k.json: {check: sheet, within: 1e-9}", BATTEN_OK,
     "\"ok\": true|\"from\": \"lifted\", \"faired\": false, \"points\": 4|!\"from\": \"low\""},
    {"k.json: {check: other, within: 1e-9}", BATTEN_OK,
     "\"ok\": true|\"from\": \"image\"|!\"from\": \"low\""},
    {"k.json: {check: twins, within: 1e-9}", BATTEN_OK, "\"ok\": true|\"from\": \"low\""},
    {"k.json: {check: shell, within: 1e-9}", BATTEN_OK, "\"ok\": true|\"distances\": []"},
    {"k.json: {check: slid, within: 1e-9}", BATTEN_OK,
     "\"ok\": true|\"from\": \"low\"|!\"from\": \"way\""},
    {"k.json: {check: tube, within: 1e-9}", BATTEN_OK, "\"ok\": true|\"distances\": []"},
    /* Moved after fairing: faired points, and no place where those given would be. */
    {"k.json: {check: pair}", BATTEN_OK,
     "\"from\": \"high\", \"faired\": false|\"from\": \"faired\", \"faired\": true|\"from\": "
     "\"raised\", \"faired\": true"},
    {"k.json: {check: top, within: 1e-9}", BATTEN_OK,
     "\"ok\": true|\"from\": \"lifted\", \"faired\": false|\"from\": \"raised\", \"faired\": "
     "true|!\"from\": \"high\""},
};

TEST(all_points_that_lie_on_a_shape_are_measured_and_no_others)
{
    EXPECT_OUTPUTS(several, several_rows);
}
