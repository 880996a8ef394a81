#include <batten/base.h>

#include "support/test.h"

TEST(notes_are_kept_in_order)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(100, &notes));
    for (int i = 0; i < 20; i++)
        batten_notes_add(notes, "hull.igs", i + 1, i % 2 ? "entity 7" : NULL, "weight %d is %d",
                         i, -i);
    CHECK_INT(batten_notes_count(notes) + batten_notes_dropped(notes), 20);
    for (int i = 0; batten_notes_dropped(notes) == 0 && i < 20; i++) {
        const batten_note *note = batten_notes_at(notes, i);
        char text[40];
        snprintf(text, sizeof text, "weight %d is %d", i, -i);
        CHECK_TEXT(note->file, "hull.igs");
        CHECK_INT(note->line, i + 1);
        CHECK_TEXT(note->entity, i % 2 ? "entity 7" : "");
        CHECK_TEXT(note->text, text);
    }
    batten_notes_free(notes);
}

TEST(notes_beyond_the_limit_are_counted)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(9, &notes));
    for (int i = 0; i < 20; i++)
        batten_notes_add(notes, NULL, 0, "", "again");
    CHECK(batten_notes_count(notes) <= 9 && batten_notes_dropped(notes) >= 11);
    CHECK_INT(batten_notes_count(notes) + batten_notes_dropped(notes), 20);
    batten_notes_free(notes);
    CHECK_OK(batten_notes_create(0, &notes));
    batten_notes_add(notes, "", 0, "", "none is kept");
    CHECK_INT(batten_notes_dropped(notes), 1);
    batten_notes_free(notes);
}

TEST(no_notes_are_borne_silently)
{
    batten_notes_add(NULL, "", 0, "", "nobody listens");
    batten_notes_free(NULL);
    batten_notes *notes = NULL;
    CHECK_STATUS(batten_notes_create(-1, &notes), BATTEN_BAD_ARGUMENT);
    CHECK(notes == NULL);
}

TEST(remarks_are_told_from_warnings)
{
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(9, &notes));
    batten_notes_add(notes, "", 0, "", "a point is missing");
    batten_notes_remark(notes, "a.yaml", 3, "arcs", "%d arcs", 7);
    if (batten_notes_dropped(notes) == 0) {
        CHECK(!batten_notes_at(notes, 0)->is_remark);
        CHECK(batten_notes_at(notes, 1)->is_remark);
        CHECK_TEXT(batten_notes_at(notes, 1)->text, "7 arcs");
        CHECK_INT(batten_notes_at(notes, 1)->line, 3);
    }
    batten_notes_free(notes);
    batten_notes_remark(NULL, "", 0, "", "nobody listens");
}
