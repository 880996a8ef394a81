#include "exchange/losses.h"

#include "exchange/formats.h"
#include "exchange/shapes.h"

/* What is said of one object that has everything, to the letter. */
static void check_losses(const bat_format_row *row, const batten_object *object,
                         const char *listing)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    char list[4000] = "";
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is a test of the corpora");
    CHECK_OK(batten_model_create(1, &model));
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_OK(batten_model_add(model, object));
    CHECK_OK(bat_note_losses(model, row, notes));
    for (int i = 0; i < batten_notes_count(notes); i++) {
        const batten_note *n = batten_notes_at(notes, i);
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s%d: %s%s\n",
                 n->is_remark ? "~" : "", n->line, n->entity, n->text);
    }
    CHECK_TEXT(list, listing);
    batten_notes_free(notes);
    batten_model_unref(model);
}

static const double points[] = {0, 0, 0, 1, 0, 0};

TEST(what_a_format_does_not_say_is_listed_in_one_note_each)
{
    const batten_object object = {.name = "keel",
                                  .layer = "7",
                                  .group = "g",
                                  .has_colour = true,
                                  .is_hidden = true,
                                  .kind = BATTEN_OBJECT_POINTS,
                                  .point_count = 2,
                                  .points = points};
    bat_format_row row = {.title = "X", .holds = BAT_HOLDS(POINTS)};
    static const char *const losses[] = {
        "~0: names left out: 1 ('keel' first); X files hold none\n",
        "0: layers left out: 1 ('keel' first); X files hold none\n",
        "0: colours left out: 1 ('keel' first); X files hold none\n",
        "0: groups left out: 1 ('keel' first); X files hold none\n",
        "0: that objects are hidden is left out: 1 ('keel' first); X files hold none\n"};
    for (unsigned says = 0; says <= BAT_SAYS_ALL; says++) {
        char listing[1000] = "";
        for (int k = 0; k < 5; k++)
            if (!(says >> k & 1))
                strcat(listing, losses[k]);
        row.says = says;
        check_losses(&row, &object, listing);
    }
    row.says = BAT_SAYS_ALL;
    row.lesser = BAT_HOLDS(POINTS);
    row.lacks = BAT_SAYS_COLOURS;
    check_losses(&row, &object,
                 "0: colours left out: 1 ('keel' first); X files hold none for this row of points\n");
    row.lesser = BAT_HOLDS(CURVE);
    check_losses(&row, &object, "");
    row.holds = row.says = 0;
    check_losses(&row, &object, "");
}

TEST(names_that_readers_make_up_are_no_loss)
{
    static const struct {
        const char *name;
        bool is_own;
    } cases[] = {{"", false},
                 {"curve 1", false},
                 {"curve D12", false},
                 {"LINE 3", false},
                 {"mesh", false},
                 {"curve 1x", true},
                 {"curve Dx", true},
                 {"keel", true},
                 {"keel 1", true},
                 {"curve E1", true},
                 {"a long name of a keel", true},
                 {"polylines 1", true},
                 {"lwpolyline 7", false}};
    const bat_format_row row = {
        .title = "X", .holds = BAT_HOLDS(POINTS), .says = BAT_SAYS_ALL & ~1u};
    for (int i = 0; i < COUNT(cases); i++) {
        char listing[200] = "";
        if (cases[i].is_own)
            snprintf(listing, sizeof listing,
                     "~0: names left out: 1 ('%s' first); X files hold none\n", cases[i].name);
        check_losses(&row,
                     &(batten_object){.name = cases[i].name,
                                      .kind = BATTEN_OBJECT_POINTS,
                                      .point_count = 2,
                                      .points = points},
                     listing);
    }
}

TEST(a_format_that_names_layers_loses_names_only_of_what_has_one)
{
    const bat_format_row row = {.title = "X",
                                .holds = BAT_HOLDS(POINTS),
                                .says = BAT_SAYS_ALL & ~1u,
                                .names_layers = true};
    batten_object object = {
        .name = "keel", .kind = BATTEN_OBJECT_POINTS, .point_count = 2, .points = points};
    check_losses(&row, &object, "");
    object.layer = "7";
    check_losses(
        &row, &object,
        "~0: names left out: 1 ('keel' first); X files hold none but those of layers\n");
}
