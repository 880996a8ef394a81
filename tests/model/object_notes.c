#include "model/object_notes.h"

#include "support/test.h"

static void check_note(const batten_notes *notes, int index, const char *entity,
                       const char *text)
{
    if (index < batten_notes_count(notes)) {
        CHECK_TEXT(batten_notes_at(notes, index)->entity, entity);
        CHECK_TEXT(batten_notes_at(notes, index)->text, text);
    }
}

TEST(notes_of_faces_are_of_their_object_and_counted)
{
    static const char loose[] = "its edges are more than 1e-05 off it; it was traced to %g";
    batten_notes *from = NULL, *to = NULL;
    CHECK_OK(batten_notes_create(100, &from));
    CHECK_OK(batten_notes_create(100, &to));
    batten_notes_add(from, "", 0, "face 6", loose, 0.0012);
    batten_notes_add(from, "", 0, "face 7", "left out: it has 3 corners");
    batten_notes_add(from, "", 0, "face 8", loose, 0.25);
    batten_notes_add(from, "", 0, "face 9", loose, 0.002);
    batten_notes_remark(from, "", 0, "", "approximated");
    bat_object_notes(from, "bolt_1", 0.001, to);
    if (!batten_notes_dropped(from) && !batten_notes_dropped(to)) {
        CHECK_INT(batten_notes_count(to), 3);
        check_note(to, 0, "bolt_1: face 8",
                   "its edges are more than 1e-05 off it; it was traced to 0.25 mm; and 2 more "
                   "like it");
        check_note(to, 1, "bolt_1: face 7", "left out: it has 3 corners");
        check_note(to, 2, "bolt_1", "approximated");
        CHECK(batten_notes_at(to, 2)->is_remark);
    }
    batten_notes_free(from);
    batten_notes_free(to);
}

TEST(kinds_of_notes_beyond_some_are_handed_on_one_by_one)
{
    batten_notes *from = NULL, *to = NULL;
    CHECK_OK(batten_notes_create(100, &from));
    CHECK_OK(batten_notes_create(100, &to));
    for (int i = 0; i < 40; i++)
        batten_notes_add(from, "", 0, "face 2", "odd in its way %c", 'A' + i % 20);
    bat_object_notes(from, "", 0, to);
    if (!batten_notes_dropped(from) && !batten_notes_dropped(to)) {
        CHECK_INT(batten_notes_count(to), 8 + 16);
        check_note(to, 0, "face 2", "odd in its way Q");
        check_note(to, 8, "face 2", "odd in its way A; and 1 more like it");
    }
    batten_notes_free(from);
    batten_notes_free(to);
}
