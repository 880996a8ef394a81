/* Tracing of every face as finely as its edges allow. */
#include "body/trace/all.h"
#include "body/by_hand.h"
#include "support/test.h"

/* Plates with a round hole each; the plate of number `bad` lies beside its circle by so much. */
static batten_body *plates(int count, int bad, double beside)
{
    hand m = hand_begin();
    batten_body *body = NULL;
    for (int k = 0; k < count; k++) {
        hand_arc(&m, 1, 3 * k, 0, 360);
        hand_plate(&m, -2, -2, 2, 2, 3 * k + (k == bad ? beside : 0));
        hand_loop(&m, 1, (const int[]){k + 1});
    }
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    return body;
}

TEST(a_body_is_traced_when_all_its_faces_have_loops_and_it_says_so)
{
    static const struct {
        bool said;
        int loops[2];
        bool is;
    } rows[] = {{true, {1, 2}, true},
                {true, {1, 0}, false},
                {true, {0, 1}, false},
                {false, {1, 1}, false}};
    for (int i = 0; i < COUNT(rows); i++) {
        const batten_body_face faces[2] = {{.count = rows[i].loops[0]},
                                           {.count = rows[i].loops[1]}};
        const batten_body_parts parts = {
            .face_count = 2, .faces = faces, .is_traced = rows[i].said};
        CHECK_INT(bat_is_traced(&parts), rows[i].is);
    }
}

TEST(a_traced_body_stays_as_it_is)
{
    batten_body *body = plates(2, -1, 0), *traced = NULL;
    bat_traced_all all = {.failed = 7};
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, NULL, &traced));
    CHECK_OK(bat_trace_all(traced, 1, NULL, &all));
    CHECK_INT(all.count, 1);
    CHECK(all.at[0].body == traced && all.at[0].numbers == NULL && all.is_failed == NULL);
    CHECK(all.failed == 0 && all.rims == 0 && all.at[0].tolerance == 0);
    bat_trace_all_end(&all);
    CHECK(all.count == 0 && all.is_failed == NULL);
    batten_body_unref(traced);
    batten_body_unref(body);
}

/* One of three plates is 0.07 off its circle: it fails at 1e-6, and at each tenfold of that below 0.1. */
TEST(faces_that_fail_are_traced_again_ten_times_as_coarse_up_to_the_coarsest)
{
    static const struct {
        double coarsest;
        int rounds;
        bool fails;
    } rows[] = {{1e-7, 1, true}, {1e-6, 1, true},  {9.9e-6, 1, true}, {1.1e-5, 2, true},
                {1, 6, false},   {0.11, 6, false}, {0.09, 5, true}};
    for (int bad = 0; bad < test_cases(3) && bad < 3; bad++)
        for (int i = 0; i < COUNT(rows); i++) {
            batten_body *body = plates(3, bad, 0.07);
            bat_traced_all all = {.failed = 7};
            CHECK_OK(bat_trace_all(body, rows[i].coarsest, NULL, &all));
            CHECK_INT(all.count, rows[i].rounds);
            CHECK_INT(all.failed, rows[i].fails);
            CHECK_INT(all.rims, 0);
            for (int f = 0; f < 3; f++)
                CHECK_INT(all.is_failed[f], rows[i].fails && f == bad);
            for (int k = 0; k < all.count; k++) {
                const batten_body_parts *p = batten_body_view(all.at[k].body);
                CHECK_NEAR(all.at[k].tolerance, 1e-6 * pow(10, k), 1e-9 * pow(10, k - 6));
                CHECK_INT(p->face_count, k == 0 ? 2 : k == 5);
                if (k == 0)
                    for (int f = 0; f < 2; f++)
                        CHECK_INT(bat_traced_number(&all.at[0], f), f + (f >= bad));
            }
            if (!rows[i].fails)
                CHECK_INT(bat_traced_number(&all.at[5], 0), bad);
            bat_trace_all_end(&all);
            batten_body_unref(body);
        }
}

/* A disc and cylinders on its circle: each cylinder ends where its surface does, at a rim that no loop says. */
TEST(rims_of_surfaces_are_counted_over_all_rounds)
{
    hand m = hand_begin();
    batten_body *body = NULL;
    bat_traced_all all;
    for (int k = 0; k < 2; k++) {
        hand_arc(&m, 3, 1 + 20 * k, 0, 360);
        hand_plate(&m, -4, -4, 4, 4, 1 + 20 * k);
        hand_loop(&m, 1, (const int[]){k + 1});
    }
    hand_face(&m, hand_cylinder(3, 6), false);
    HAND_LOOP(&m, 1);
    hand_face(&m, hand_cylinder(3, 26), false);
    HAND_LOOP(&m, 2);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(bat_trace_all(body, 1e-3, NULL, &all));
    CHECK(all.count == 1 && all.failed == 0);
    CHECK_INT(all.rims, 2);
    bat_trace_all_end(&all);
    batten_body_unref(body);
}
