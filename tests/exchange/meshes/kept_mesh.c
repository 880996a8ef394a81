#include "exchange/meshes/kept_mesh.h"

#include "exchange/meshes/meshes.h"

/* What a format keeps of a mesh that has all three, and what it says of the rest. */
TEST(a_format_keeps_what_it_holds_and_names_what_it_does_not)
{
    static const struct {
        int bit;
        const char *words;
    } parts_of[] = {
        {BAT_KEEPS_COLOURS,
         "the colours of its vertices are left out: X files do not hold them"},
        {BAT_KEEPS_TRIANGLE_COLOURS,
         "the colours of its faces are left out: X files do not hold them"},
        {BAT_KEEPS_VALUES,
         "further values of each vertex: 1; left out, as X files do not hold them"}};
    static const double numbers[12] = {0.5};
    if (test_cases(1000) < 1000)
        SKIP("what missing memory does is a test of the corpora");
    batten_mesh_parts parts = tetrahedron();
    parts.colours = parts.triangle_colours = numbers;
    parts.attribute_count = 1;
    parts.attributes = &(const batten_mesh_attribute){"h", numbers};
    batten_mesh *mesh = NULL, *kept = NULL;
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    const batten_object object = {.name = "hull", .kind = BATTEN_OBJECT_MESH, .mesh = mesh};
    for (int bits = 0; bits < 8; bits++) {
        bat_format_row row = {.title = "X", .holds = 1};
        batten_notes *notes = NULL;
        int count = 0;
        for (int k = 0; k < 3; k++)
            row.keeps |= bits >> k & 1 ? parts_of[k].bit : 0;
        CHECK_OK(batten_notes_create(9, &notes));
        CHECK_OK(bat_mesh_kept(&row, &object, notes, &kept));
        const batten_mesh_parts *p = batten_mesh_view(kept);
        CHECK_INT(p->colours != NULL, bits & 1);
        CHECK_INT(p->triangle_colours != NULL, bits >> 1 & 1);
        CHECK_INT(p->attribute_count, bits >> 2 & 1);
        CHECK_INT(p->triangle_count, 4);
        for (int k = 0; k < 3; k++)
            if (!(bits >> k & 1)) {
                const batten_note *note = batten_notes_at(notes, count++);
                CHECK_TEXT(note->text, parts_of[k].words);
                CHECK_TEXT(note->entity, "hull");
                CHECK(note->line == 0 && !note->is_remark);
            }
        CHECK_INT(batten_notes_count(notes), count);
        batten_mesh_unref(kept);
        batten_notes_free(notes);
        kept = NULL;
    }
    batten_mesh_unref(mesh);
}

TEST(a_format_of_no_restriction_and_a_bare_mesh_lose_nothing)
{
    const bat_format_row all = {.title = "X"}, least = {.title = "X", .holds = 1};
    batten_mesh *mesh = NULL, *bare = NULL, *kept = NULL;
    batten_notes *notes = NULL;
    static const double numbers[12] = {0.5};
    batten_mesh_parts parts = tetrahedron();
    CHECK_OK(batten_notes_create(9, &notes));
    CHECK_OK(batten_mesh_create(&parts, &bare));
    parts.colours = parts.triangle_colours = numbers;
    CHECK_OK(batten_mesh_create(&parts, &mesh));
    CHECK_OK(bat_mesh_kept(&all, &(batten_object){.mesh = mesh}, notes, &kept));
    CHECK(kept == mesh);
    batten_mesh_unref(kept);
    CHECK_OK(bat_mesh_kept(&least, &(batten_object){.mesh = bare}, notes, &kept));
    CHECK(kept == bare);
    batten_mesh_unref(kept);
    CHECK_INT(batten_notes_count(notes), 0);
    batten_mesh_unref(mesh);
    batten_mesh_unref(bare);
    batten_notes_free(notes);
}
