/* The volumes that shells enclose, and their rims. */
#include "body/builder.h"
#include "body/by_hand.h"
#include "support/bodies.h"
#include "support/test.h"

#include <batten/standard.h>
#include <stdlib.h>

static batten_notes *new_notes(void)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    return notes;
}

/* The number in the note after these words. */
static double number_after(const batten_notes *notes, const char *words)
{
    const char *at = strstr(batten_notes_at(notes, 0)->text, words);
    CHECK(at != NULL);
    return strtod(at + strlen(words), NULL);
}

TEST(the_volume_of_a_turned_ball_is_noted_in_model_units_with_its_error)
{
    static const double radii[] = {0.01, 1, 250};
    for (int i = 0; i < COUNT(radii); i++) {
        const double r = radii[i], volume = -4.0 / 3 * acos(-1) * r * r * r;
        batten_surface *ball = NULL;
        batten_body *body = NULL;
        batten_notes *notes = new_notes();
        batten_body_faults faults;
        bat_builder b;
        bat_builder_begin(&b, 1e-6 * r);
        CHECK_OK(batten_surface_sphere(&hand_world, r, &ball));
        CHECK_OK(bat_builder_shell(&b, true));
        CHECK_OK(bat_builder_face(&b, &(batten_body_face){.surface = ball, .reversed = true}));
        b.parts.is_solid = true;
        CHECK_OK(batten_body_create(&b.parts, &body));
        bat_builder_end(&b);
        CHECK_OK(batten_body_check(body, 1e-6 * r, NULL, notes, &faults));
        CHECK_INT(faults.turned_shells, 1);
        if (batten_notes_dropped(notes) == 0) {
            const double found = number_after(notes, "its volume is "),
                         error = number_after(notes, "within ");
            CHECK_NEAR(found, volume, 1e-2 * fabs(volume));
            CHECK(error > 0 && error < 1e-2 * fabs(volume));
        }
        batten_notes_free(notes);
        batten_body_unref(body);
        batten_surface_unref(ball);
    }
}

/* Half a ball has its circle as a rim; at the pole there is no edge in space. */
TEST(the_rim_of_an_open_shell_is_counted_without_poles_and_seams)
{
    hand m = hand_begin();
    batten_surface *ball = NULL;
    batten_body *body = NULL, *traced = NULL, *closed = NULL;
    batten_notes *notes = new_notes();
    batten_body_faults faults;
    CHECK_OK(batten_surface_sphere(&hand_world, 2, &ball));
    hand_arc(&m, 2, 0, 0, 360);
    hand_face(&m, ball, false);
    HAND_LOOP(&m, 1);
    CHECK_OK(batten_body_create(&m.builder.parts, &body));
    bat_builder_end(&m.builder);
    CHECK_OK(batten_body_trace(body, 1e-6, NULL, NULL, NULL, &traced));
    batten_body_parts parts = *batten_body_view(traced);
    const batten_body_shell shell = {.first = 0, .count = 1, .closed = true};
    parts.shells = &shell;
    CHECK_OK(batten_body_create(&parts, &closed));
    CHECK_OK(batten_body_check(closed, 1e-5, NULL, notes, &faults));
    CHECK_INT(faults.open_shells, 1);
    CHECK_INT(faults.free_edges, 1);
    CHECK_INT(faults.poles, 1);
    CHECK_INT(faults.seams, 1);
    if (batten_notes_dropped(notes) == 0) {
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "shell 1");
        CHECK_CONTAINS(batten_notes_at(notes, 0)->text, "but 1 of its edges");
    }
    batten_notes_free(notes);
    batten_body_unref(closed);
    batten_body_unref(traced);
    batten_body_unref(body);
}

static void note_fraction(void *user, double fraction, const char *what)
{
    CHECK(fraction >= 0 && fraction <= 1);
    *(int *)user += strcmp(what, "measuring shells") == 0;
}

static bool never(void *user)
{
    (void)user;
    return false;
}

TEST(progress_of_a_check_is_a_part_of_the_whole)
{
    batten_body *box = test_box((batten_vec3){0, 0, 0}, (batten_vec3){1, 2, 3});
    batten_body_faults faults;
    int told = 0;
    batten_job job = BATTEN_JOB;
    job.is_cancelled = never;
    job.progress = note_fraction;
    job.user = &told;
    CHECK_OK(batten_body_check(box, 1e-6, &job, NULL, &faults));
    CHECK(told >= 1);
    batten_body_unref(box);
}

static int turned_in(const batten_body *body)
{
    batten_body_faults f = {.gaps = -1};
    CHECK_OK(batten_body_check(body, 1e-6, NULL, NULL, &f));
    return f.turned_shells;
}

/* A ball with a round void, each as its outside is said to be. */
static batten_body *hollow_ball(bool outer_turned, bool void_turned, bool is_solid)
{
    const batten_frame world = batten_frame_world();
    batten_surface *outer = NULL, *inner = NULL;
    batten_body *body = NULL;
    bat_builder b;
    bat_builder_begin(&b, 1e-9);
    CHECK_OK(batten_surface_sphere(&world, 2, &outer));
    CHECK_OK(batten_surface_sphere(&world, 1, &inner));
    CHECK_OK(bat_builder_shell(&b, true));
    CHECK_OK(
        bat_builder_face(&b, &(batten_body_face){.surface = outer, .reversed = outer_turned}));
    CHECK_OK(bat_builder_shell(&b, true));
    CHECK_OK(
        bat_builder_face(&b, &(batten_body_face){.surface = inner, .reversed = !void_turned}));
    b.parts.is_solid = is_solid;
    CHECK_OK(batten_body_create(&b.parts, &body));
    bat_builder_end(&b);
    batten_surface_unref(outer);
    batten_surface_unref(inner);
    return body;
}

TEST(shells_that_are_turned_inside_out_are_told)
{
    static const struct {
        bool outer, inner;
        const char *entity, *words;
    } cases[] = {
        {false, false, NULL, NULL},
        {true, false, "shell 1", "bounds the solid and is turned inward: its volume is -33.51"},
        {false, true, "shell 2",
         "bounds a void of the solid and is turned outward: its volume is 4.188"}};
    for (int i = 0; i < 3; i++) {
        batten_body *body = hollow_ball(cases[i].outer, cases[i].inner, true);
        batten_notes *notes = new_notes();
        batten_body_faults f = {.gaps = -1};
        CHECK_OK(batten_body_check(body, 1e-6, NULL, notes, &f));
        CHECK_INT(f.turned_shells, i > 0);
        if (batten_notes_dropped(notes) == 0)
            CHECK_INT(batten_notes_count(notes), i > 0);
        if (batten_notes_dropped(notes) == 0 && i > 0) {
            CHECK_TEXT(batten_notes_at(notes, 0)->entity, cases[i].entity);
            CHECK_CONTAINS(batten_notes_at(notes, 0)->text, cases[i].words);
        }
        batten_notes_free(notes);
        batten_body_unref(body);
    }
    batten_body *both = hollow_ball(true, true, true), *sheets = hollow_ball(true, true, false);
    CHECK_INT(turned_in(both), 2);
    CHECK_INT(turned_in(sheets), 0);
    batten_body_unref(both);
    batten_body_unref(sheets);
}

/* A box with a ball in it; of the box one plane lies far beside its edges when `broken`. */
static batten_body *box_around_ball(bool box_turned, bool ball_turned, bool broken)
{
    batten_body *box = test_box((batten_vec3){-3, -3, -3}, (batten_vec3){3, 3, 3}),
                *body = NULL;
    batten_body_parts parts = *batten_body_view(box);
    batten_body_face faces[7];
    batten_body_use uses[24];
    const batten_body_shell shells[2] = {{0, 6, true}, {6, 1, true}};
    const batten_affine aside = batten_affine_translation(-4, 0, 0);
    batten_surface *ball = NULL, *moved = NULL;
    CHECK_OK(batten_surface_sphere(&hand_world, 1, &ball));
    CHECK_OK(batten_surface_transform(parts.faces[0].surface, &aside, &moved));
    memcpy(faces, parts.faces, 6 * sizeof *faces);
    for (int f = 0; f < 6; f++)
        faces[f].reversed = faces[f].reversed != box_turned;
    for (int u = 0; u < 24; u++) {
        uses[u] = parts.uses[box_turned ? u / 4 * 4 + 3 - u % 4 : u];
        uses[u].reversed = uses[u].reversed != box_turned;
    }
    if (broken)
        faces[0].surface = moved;
    faces[6] = (batten_body_face){
        .surface = ball, .reversed = !ball_turned, .first = parts.loop_count, .name = ""};
    parts.faces = faces;
    parts.face_count = 7;
    parts.uses = uses;
    parts.shells = shells;
    parts.shell_count = 2;
    CHECK_OK(batten_body_create(&parts, &body));
    batten_surface_unref(moved);
    batten_surface_unref(ball);
    batten_body_unref(box);
    return body;
}

TEST(a_shell_with_a_face_that_cannot_be_measured_is_not_judged_and_others_are)
{
    for (int i = 0; i < 8; i++) {
        const bool box_turned = i & 1, ball_turned = i & 2, broken = i & 4;
        batten_body *body = box_around_ball(box_turned, ball_turned, broken);
        CHECK_INT(turned_in(body), (box_turned && !broken) + ball_turned);
        batten_body_unref(body);
    }
}
