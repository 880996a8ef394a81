#include "exchange/reading/census.h"

#include "exchange/reading.h"

static batten_notes *notes_of(const bat_census *census)
{
    batten_notes *notes = NULL;
    bat_input input;
    CHECK_OK(batten_notes_create(2000, &notes));
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, notes, &input));
    input.file = "f";
    bat_census_note(&input, census);
    return notes;
}

TEST(entities_are_counted_by_name_in_the_order_of_the_alphabet)
{
    static const char *const met[] = {"LINE", "ARC", "TEXT", "ARC", "CIRCLE", "LINE", "ARC"};
    static const struct {
        const char *name, *text;
        bool is_remark;
    } due[] = {{"ARC", "3 read", true},
               {"CIRCLE", "0 read, 1 left out", false},
               {"LINE", "2 read, 1 left out", false},
               {"TEXT", "1 read", true}};
    bat_input input;
    bat_census census;
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, NULL, &input));
    bat_census_begin(&census);
    for (int i = 0; i < COUNT(met); i++)
        if (i != 4)
            CHECK_OK(bat_census_read(&input, &census, met[i]));
    CHECK_OK(bat_census_leave(&input, &census, "CIRCLE"));
    CHECK_OK(bat_census_leave(&input, &census, "LINE"));
    batten_notes *notes = notes_of(&census);
    bat_census_end(&census);
    if (!batten_notes_dropped(notes)) {
        CHECK_INT(batten_notes_count(notes), COUNT(due));
        for (int i = 0; i < COUNT(due); i++) {
            const batten_note *note = batten_notes_at(notes, i);
            CHECK_TEXT(note->entity, due[i].name);
            CHECK_TEXT(note->text, due[i].text);
            CHECK_INT(note->is_remark, due[i].is_remark);
            CHECK_TEXT(note->file, "f");
            CHECK_INT(note->line, 0);
        }
    }
    batten_notes_free(notes);
}

TEST(after_a_thousand_names_the_rest_are_counted_as_one)
{
    bat_input input;
    bat_census census;
    CHECK_OK(bat_input_begin("", 0, NULL, NULL, NULL, &input));
    bat_census_begin(&census);
    for (int i = 0; i < 1010; i++) {
        char name[120];
        snprintf(name, sizeof name, "z%04d%*s", (i * 7) % 1010, 90, "tail");
        CHECK_OK(bat_census_read(&input, &census, name));
    }
    batten_notes *notes = notes_of(&census);
    bat_census_end(&census);
    if (!batten_notes_dropped(notes)) {
        CHECK_INT(batten_notes_count(notes), 1001);
        CHECK_TEXT(batten_notes_at(notes, 0)->entity, "and others");
        CHECK_TEXT(batten_notes_at(notes, 0)->text, "10 read");
        CHECK_INT((long long)strlen(batten_notes_at(notes, 1)->entity), 79);
        for (int i = 2; i < 1001; i++)
            CHECK(strcmp(batten_notes_at(notes, i - 1)->entity,
                         batten_notes_at(notes, i)->entity) < 0);
    }
    batten_notes_free(notes);
}
