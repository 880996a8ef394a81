#include "design/evaluate.h"

/* Three ribs over two stringers and a keel; the ribs begin at the keel. */
static const char common[] =
    "batten: 1\nunits: mm\nfeatures:\n"
    "  keel: {polyline: [[0, 0, 0], [3000, 0, 0]]}\n"
    "  chine: {polyline: [[0, 500, 100], [3000, 500, 100]]}\n"
    "  sheer: {polyline: [[0, 700, 600], [3000, 700, 600]]}\n"
    "  bent: {polyline: [[0, 500, 100], [1500, 550, 80], [3000, 500, 100]]}\n"
    "  rib-1: {polyline: [[0, 0, 0], [0, 500, 100], [0, 700, 600]]}\n"
    "  rib-2: {polyline: [[1500, 700, 600], [1500, 500, 100], [1500, 0, 0]]}\n"
    "  rib-3: {polyline: [[3000, 0, 0], [3000, 500, 100], [3000, 700, 600]]}\n"
    "  rib-4: {polyline: [[1500, 700, 600], [1500, 499.9, 99.9], [1500, 0, 0]]}\n"
    "  lone: {polyline: [[1500, 900, 600], [1500, 900, 0]]}\n"
    "  mixed: {collect: [rib-1, rib-4, rib-3, keel, chine, sheer]}\n"
    "  small: {scale: mixed, by: 0.001}\n"
    "  ribs: {collect: [rib-1, rib-2, rib-3]}\n"
    "  long: {collect: [keel, chine, sheer]}\n";

static batten_status evaluate(const char *feature, batten_notes *notes, batten_design **out)
{
    char text[3000];
    snprintf(text, sizeof text, "%s  a: %s\n", common, feature);
    return evaluate_design(text, "a", notes, out);
}

TEST(networks_become_surfaces)
{
    static const char *const rows[] = {
        "{gordon: ribs, guides: long}",
        "{gordon: [chine, rib-2, rib-1, sheer, keel, rib-3]}",
        "{gordon: ribs, guides: long, blend: linear}",
        "{gordon: ribs, guides: long, blend: lagrange}",
        "{gordon: [rib-1, rib-4, rib-3], guides: long, within: 1}",
        "{gordon: [rib-1, rib-2], guides: long}",
        "{gordon: [rib-1, rib-4, rib-3], guides: long, within: 0.01, gap: 0.06}",
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        CHECK_OK(evaluate(rows[i], NULL, &design));
        const batten_feature_result *result = batten_design_result(design, "a");
        CHECK_INT(batten_model_count(result->value), 1);
        const batten_object *object = batten_model_object(result->value, 0);
        CHECK_INT(object->kind, BATTEN_OBJECT_SURFACE);
        CHECK(result->has_error && result->error_max <= (i == 4 ? 1 : i == 6 ? 0.03 : 1e-6));
        batten_design_free(design);
    }
}

TEST(G7_networks_with_gaps_are_refused_by_name)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{gordon: [rib-1, rib-4, rib-3], guides: long, within: 0.01}",
         "profile 'rib-4' (2 of 3) misses guide 'chine' (2 of 3) by 0.0556952 near"},
        {"{gordon: [rib-1, rib-4, rib-3], guides: long, within: 0.01}",
         "of 9 pairs 1 is apart; a gap of 0.056 would join them"},
        {"{gordon: [rib-1, lone], guides: long}",
         "profile 'lone' (2 of 2) misses guide 'keel' (1 of 3) by 900"},
        {"{gordon: [ribs, long, lone]}",
         "'lone' (7 of 7) meets no other curve; 'rib-2' (2 of 7) is nearest, 200 away"},
        {"{gordon: ribs, guides: ribs}",
         "profile 'rib-1' (1 of 3) and guide 'rib-1' (1 of 3) "},
        {"{gordon: [rib-1, rib-2], guides: long, cut: no}", "extends 1500 beyond"},
        {"{gordon: ribs, guides: keel}", "there is 1 guide"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_design *design = NULL;
        batten_status status = evaluate(rows[i].feature, NULL, &design);
        if (status == BATTEN_OUT_OF_MEMORY)
            status = evaluate(rows[i].feature, NULL, &design);
        CHECK(status != BATTEN_OK);
        if (status != BATTEN_OUT_OF_MEMORY)
            CHECK_MESSAGE(rows[i].says);
    }
}

/* Three rings and one line along them: the surface turns with the rings. */
TEST(closed_profiles_may_have_one_guide)
{
    static const char *const rows[] = {"{gordon: rings, guides: one}",
                                       "{gordon: [c0, c2], guides: [one, one]}"};
    for (int i = 0; i < COUNT(rows); i++) {
        char text[1000];
        batten_design *design = NULL;
        snprintf(text, sizeof text,
                 "batten: 1\nunits: m\nfeatures:\n  c0: {circle: 1}\n"
                 "  c1: {circle: 2, at: [0, 0, 1]}\n  c2: {circle: 1, at: [0, 0, 2]}\n"
                 "  rings: {collect: [c0, c1, c2]}\n"
                 "  l: {points: [[1, 0, 0], [2, 0, 1], [1, 0, 2]]}\n"
                 "  m: {points: [[1, 0, 0], [1.5, 0, 1], [1, 0, 2]]}\n"
                 "  one: {interpolate: %s}\n  a: %s\n",
                 i ? "m" : "l", rows[i]);
        CHECK_OK(evaluate_design(text, "a", NULL, &design));
        batten_design_free(design);
    }
}

/* A network of a few millimetres in a design of a tenth: its own size says how exact it is. */
TEST(what_is_coarse_or_off_is_said)
{
    static const struct {
        const char *feature, *says;
    } rows[] = {
        {"{gordon: small}", "is made within 0.000314, not the design's tolerance"},
        {"{gordon: small}",
         "profile 'rib-4' (2 of 3) and guide 'chine' (2 of 3) are 5.57e-05 apart"},
        {"{gordon: small, within: 0.01}",
         "within 0.01 is coarse for a network that is 3.14 across; try within: 0.0003"},
        {"{gordon: [rib-1, rib-3], guides: long, within: 100}", "is coarse"},
        {"{gordon: [rib-1, rib-3], guides: [keel, bent, sheer]}",
         "guide 'bent' (2 of 3) leaves the skin of the profiles alone by up to"},
    };
    for (int i = 0; i < COUNT(rows); i++) {
        batten_notes *notes = NULL;
        batten_design *design = NULL;
        bool said = false;
        CHECK_OK(batten_notes_create(100, &notes));
        CHECK_OK(evaluate(rows[i].feature, notes, &design));
        for (int k = 0; k < batten_notes_count(notes); k++)
            said = said || strstr(batten_notes_at(notes, k)->text, rows[i].says);
        CHECK(said || batten_notes_dropped(notes) > 0);
        batten_design_free(design);
        batten_notes_free(notes);
    }
}
