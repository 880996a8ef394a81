#include "design/evaluate.h"
#include "design/expect.h"

#include <batten/curve.h>

#define ROW                                                                                    \
    "  row: {points: [[1, 0.002], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], "           \
    "[0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, -0.002]]}\n"                               \
    "  upright: {points: [[1, 5, 0.002], [0.7, 5, 0.055], [0.3, 5, 0.09], [0.05, 5, 0.05], "   \
    "[0, 5, 0], [0.05, 5, -0.03], [0.3, 5, -0.04], [0.7, 5, -0.02], [1, 5, -0.002]]}\n"        \
    "  nose: {points: [[0, 0], [0.3, 0.09], [0.7, 0.05], [1, 0], [0.7, -0.05], [0.3, -0.09], " \
    "[0, 0]]}\n"                                                                               \
    "  few: {points: [[1, 0], [0.5, 0.1], [0, 0]]}\n"

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[4000];
    snprintf(text, sizeof text, "batten: 1\nunits: m\nfeatures:\n%s  a: %s\n", ROW, feature);
    return evaluate_design(text, "a", notes, out);
}

TEST(a_section_becomes_a_curve_of_the_chord_in_the_plane_of_its_points)
{
    batten_design *design = NULL;
    CHECK_OK(evaluate("{aerofoil: upright, chord: 2 m, trailing-edge: 0, thickness: 0.1, "
                      "panels: 40}",
                      NULL, &design));
    const batten_feature_result *result = batten_design_result(design, "a");
    CHECK_INT(batten_model_count(result->value), 1);
    const batten_curve *curve = batten_model_object(result->value, 0)->curve;
    CHECK_INT(batten_curve_point_count(curve), 41);
    CHECK_INT(batten_curve_dimension(curve), 3);
    for (int i = 0; i <= 2; i++) {
        double at[3];
        CHECK_OK(batten_curve_evaluate(curve, i / 2.0, 0, at));
        CHECK_NEAR(at[0], i == 1 ? 0 : 2, 1e-12);
        CHECK_BITS(at[1], 5.0);
        CHECK_NEAR(at[2], 0, 1e-9);
    }
    /* The points lie elsewhere: they are no data to compare the curve with. */
    CHECK_INT(batten_model_object(result->value, 0)->point_count, 0);
    CHECK(result->has_error);
    CHECK(result->error_max < 2e-3);
    batten_design_free(design);
}

static const struct {
    const char *feature, *message;
    batten_status status;
} refused[] = {
    {"{aerofoil: row, chord: 0 m}", "'chord' is 0; it must be above 0", BATTEN_BAD_ARGUMENT},
    {"{aerofoil: row, thickness: 0}", "'thickness' is 0", BATTEN_BAD_ARGUMENT},
    {"{aerofoil: row, trailing-edge: -0.1}", "'trailing-edge' is -0.1", BATTEN_BAD_ARGUMENT},
    {"{aerofoil: row, panels: 7}", "the number of panels is 7", BATTEN_BAD_ARGUMENT},
    {"{aerofoil: few}", "no row has 5 points", BATTEN_TOO_FEW_POINTS},
};

TEST(values_out_of_range_are_refused_by_the_name_of_the_parameter)
{
    for (int i = 0; i < COUNT(refused); i++) {
        batten_design *design = NULL;
        CHECK_STATUS(evaluate(refused[i].feature, NULL, &design), refused[i].status);
        CHECK_MESSAGE(refused[i].message);
    }
}

static bool has_text(const batten_notes *notes, const char *part, bool is_remark)
{
    for (int i = 0; i < batten_notes_count(notes); i++)
        if (batten_notes_at(notes, i)->is_remark == is_remark &&
            strstr(batten_notes_at(notes, i)->text, part))
            return true;
    return batten_notes_dropped(notes) > 0;
}

TEST(what_was_given_and_made_is_remarked_and_what_is_wrong_is_noted)
{
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    CHECK_OK(evaluate("{aerofoil: [row, nose], trailing-edge: 0.01}", notes, &design));
    CHECK(has_text(notes, "'row', given: chord 1", true));
    CHECK(has_text(notes, "trailing edge 0.4000 %", true));
    CHECK(has_text(notes, "trailing edge 1.0000 %", true));
    CHECK(has_text(notes, "'nose': its tail is rounder than its nose", false) ||
          has_text(notes, "'nose': the nose was on the right", true));
    batten_design_free(design);
    batten_notes_free(notes);
}

static const char orders[] =
    "  straight: {points: [[1, 0.002], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, -0.002]]}\n"
    "  reversed: {points: [[1, -0.002], [0.7, -0.02], [0.3, -0.04], [0.05, -0.03], [0, 0], [0.05, 0.05], [0.3, 0.09], [0.7, 0.055], [1, 0.002]]}\n"
    "  halves: {points: [[0, 0], [0.05, 0.05], [0.3, 0.09], [0.7, 0.055], [1, 0.002], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, -0.002]]}\n"
    "  mirrored: {points: [[-1, 0.002], [-0.7, 0.055], [-0.3, 0.09], [-0.05, 0.05], [0, 0], [-0.05, -0.03], [-0.3, -0.04], [-0.7, -0.02], [-1, -0.002]]}\n"
    "  once: {points: [[1, 0.002], [0.7, 0.055], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, -0.002]]}\n"
    "  twice: {points: [[1, 0.002], [0.7, 0.055], [0.7, 0.055], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, -0.002]]}\n"
    "  base: {points: [[1, 0.002], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, -0.002], [1, 0.002]]}\n"
    "  bases: {points: [[1, 0], [1, 0.002], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, -0.002], [1, 0]]}\n"
    "  sharp: {points: [[1, 0], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02]]}\n"
    "  below: {points: [[1, -0.004], [0.7, 0.055], [0.3, 0.09], [0.05, 0.05], [0, 0], [0.05, -0.03], [0.3, -0.04], [0.7, -0.02], [1, 0.004]]}\n";

static const expect_row of_orders[] = {
    {"{aerofoil: halves}", BATTEN_OK,
     "notes 'halves': both sides run from the nose; notes 'halves': 1 repeated point is left out"},
    {"{aerofoil: mirrored}", BATTEN_OK,
     "notes 'mirrored': the nose was on the right; notes the section is mirrored"},
    {"{aerofoil: reversed}", BATTEN_OK,
     "notes 'reversed': the lower side came first; notes the order is reversed"},
    {"{aerofoil: sharp}", BATTEN_OK,
     "notes 'sharp': one end alone is at the trailing edge; notes its point is repeated"},
    {"{aerofoil: once}", BATTEN_OK, "notes 'once': 1 repeated point is left out"},
    {"{aerofoil: twice}", BATTEN_OK, "notes 'twice': 2 repeated points are left out"},
    {"{aerofoil: base}", BATTEN_OK,
     "notes 'base': 1 point on the base of the trailing edge is left out"},
    {"{aerofoil: bases}", BATTEN_OK,
     "notes 'bases': 2 points on the base of the trailing edge are left out"},
    {"{aerofoil: below}", BATTEN_OK,
     "notes 'below': its upper side ends 0.008 of the chord below the lower one; notes 'below': its sides cross at 1 place, first at 0.; notes trailing edge -0.79"},
    {"{aerofoil: straight, chord: 2, trailing-edge: 0.02, thickness: 0.2}", BATTEN_OK,
     "notes 'straight', given: chord 1.0000; notes trailing edge 0.4000 %; notes 'straight', made: chord 2, thickness 20.000 %; notes trailing edge 2.0000 %; notes 'straight': moved by up to "},
};

TEST(what_is_odd_about_the_order_of_the_points_is_remarked)
{
    EXPECT(orders, of_orders);
}

/* ---- the published sections, when they are there ---- */

static const char *const files[] = {
    "ag35",      "ah93w480b",  "clarky",         "dae11",          "e423",
    "e63",       "fx63137",    "goe300",         "goe417a",        "raf15",
    "naca23021", "naca643618", "s1223",          "sc20410",        "tp29-5",
    "usa35b",    "whitcomb",   "naca0012_pygeo", "naca0012_sharp", "naca2412_pygeo"};

/* All sections, each in two places, and all pairs of them skinned: k1x2 ... */
static void write_pairs(char *text, size_t room, const char *edge)
{
    size_t used = (size_t)snprintf(text, room, "batten: 1\nunits: m\nfeatures:\n");
    for (int i = 0; i < COUNT(files); i++) {
        char path[100];
        snprintf(path, sizeof path, "airfoils/%s.dat", files[i]);
        used += (size_t)snprintf(text + used, room - used,
                                 "  r%d: {read: '%s'}\n"
                                 "  s%d: {aerofoil: r%d, chord: 1 m, trailing-edge: %s}\n"
                                 "  t%d: {move: s%d, by: [0, 0, 1]}\n",
                                 i, test_data(path), i, i, edge, i, i);
    }
    used += (size_t)snprintf(text + used, room - used, "  all: {collect: [t0");
    for (int i = 0; i < COUNT(files); i++)
        for (int k = 0; k < i; k++)
            used += (size_t)snprintf(text + used, room - used, ", k%dx%d", i, k);
    used += (size_t)snprintf(text + used, room - used, "]}\n");
    for (int i = 0; i < COUNT(files); i++)
        for (int k = 0; k < i; k++)
            used += (size_t)snprintf(text + used, room - used, "  k%dx%d: {skin: [s%d, t%d]}\n",
                                     i, k, i, k);
    CHECK(used < room);
}

/* Some of the files have rows that are no points, which is said once. */
static batten_status evaluate_all(batten_design *design, batten_notes *notes)
{
    const batten_status status = batten_design_evaluate(design, "all", NULL, notes);
    return status == BATTEN_PARTLY_READ ? BATTEN_OK : status;
}

static void check_pairs(const char *edge)
{
    enum { ROOM = 40000 };
    char *text = test_array(ROOM, 1);
    batten_design *design = NULL;
    batten_notes *notes = NULL;
    write_pairs(text, ROOM, edge);
    batten_design_options options = batten_design_defaults();
    options.allow_outside = true;
    CHECK_OK(batten_notes_create(1000, &notes));
    CHECK_OK(batten_design_parse(text, strlen(text), &options, notes, &design));
    CHECK_OK(evaluate_all(design, notes));
    for (int i = 0; i < batten_notes_count(notes); i++)
        CHECK(batten_notes_at(notes, i)->entity[0] != 'k');
    const batten_model *all = batten_design_result(design, "all")->value;
    CHECK_INT(batten_model_count(all), 1 + COUNT(files) * (COUNT(files) - 1) / 2);
    /* Equal knots: a skin of two has no more points than a section. */
    CHECK_INT(batten_surface_point_count(batten_model_object(all, 1)->surface, BATTEN_U) *
                  batten_surface_point_count(batten_model_object(all, 1)->surface, BATTEN_V),
              2 * 161);
    batten_design_free(design);
    batten_notes_free(notes);
}

TEST(any_two_published_sections_make_a_skin_without_a_fold_or_a_note)
{
    check_pairs("0");
    check_pairs("0.002");
}
