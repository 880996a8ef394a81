/* The file of a box in which instances are other than they should be. */
#ifndef TESTS_EXCHANGE_STEP_READ_BENT_BOX_H
#define TESTS_EXCHANGE_STEP_READ_BENT_BOX_H
#include "exchange/step/boxes.h"

static const double ORIGIN[] = {0, 0, 0};

/* The file of a box, with other text in place of the instances that it begins with. */
static inline const char *box_with(const char *instead)
{
    box_text text;
    box_shell(box_begin(&text), 1, ORIGIN, 1, 0);
    box_add(&text, "#1000=MANIFOLD_SOLID_BREP('box',#181);\n");
    box_context(&text, 900);
    box_add(&text, "#990=SHAPE_REPRESENTATION('',(#1000),#900);\n");
    const char *file = box_end(&text);
    char *made = test_array(strlen(file) + strlen(instead) + 1, 1);
    size_t length = 0;
    for (const char *line = file; *line;) {
        const char *end = strchr(line, '\n') + 1;
        const size_t id = strcspn(line, "=") + 1;
        bool replaced = false;
        for (const char *at = instead; line[0] == '#' && at && *at; at = strchr(at, '\n') + 1)
            replaced |= strncmp(at, line, id) == 0;
        if (!replaced)
            memcpy(made + length, line, (size_t)(end - line));
        length += replaced ? 0 : (size_t)(end - line);
        if (strncmp(line, "DATA;", 5) == 0) {
            memcpy(made + length, instead, strlen(instead));
            length += strlen(instead);
        }
        line = end;
    }
    return made;
}

/* Reading ends so, with a note of these words; the body has so many faces. */
static inline void check_read(const char *file, batten_status status, const char *words,
                              int faces, bool is_solid)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(50, &notes));
    CHECK_STATUS(read_text(file, BATTEN_FORMAT_STEP, notes, &model), status);
    if (batten_notes_dropped(notes) == 0 && words[0])
        CHECK(has_note(notes, words));
    CHECK_INT(batten_model_count(model), 1);
    const batten_body_parts *parts = batten_body_view(batten_model_object(model, 0)->body);
    CHECK_INT(parts->face_count, faces);
    CHECK_INT(parts->is_solid, is_solid);
    batten_notes_free(notes);
    batten_model_unref(model);
}

static inline void check_none(const char *file)
{
    batten_model *model = NULL;
    CHECK_STATUS(read_text(file, BATTEN_FORMAT_STEP, NULL, &model), BATTEN_UNSUPPORTED);
    CHECK(!model);
}

#endif
