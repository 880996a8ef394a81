/* IGES files put together by hand, so that each record can be bent. */
#ifndef TESTS_EXCHANGE_IGES_TEXT_H
#define TESTS_EXCHANGE_IGES_TEXT_H
#include "exchange/shapes.h"

typedef struct {
    char *text;
    char *directory, *data;
    int entries, records;
} iges_text;

#define IGES_GLOBAL                                                                           \
    "1H,,1H;,1Hx,1Hx,1Hx,1Hx,32,38,6,308,15,1Hx,1.,6,1HM,1,0.,13H260101.000000,1E-6,9.,,,11," \
    "0,;"
#define IGES_LINE "110,1.,2.,3.,4.,5.,6.;"
#define IGES_CURVE \
    "126,2,2,0,0,1,0,0.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,1.,1.,0.,2.,0.,0.,0.,1.,0.,0.,0.;"
#define IGES_SURFACE                                                                           \
    "128,1,1,1,1,0,0,1,0,0,0.,0.,1.,1.,0.,0.,1.,1.,1.,1.,1.,1.,0.,0.,0.,2.,0.,0.,0.,3.,0.,2.," \
    "3.,1.,"                                                                                   \
    "0.,1.,0.,1.;"

static inline iges_text iges_begin(void)
{
    enum { ROOM = 1 << 16 };
    return (iges_text){test_array(3 * ROOM, 1), test_array(ROOM, 1), test_array(ROOM, 1), 0, 0};
}

/* Add an entry with its parameters; fields that are not given are 0. */
static inline int iges_add(iges_text *file, int type, int form, int transform, int colour,
                           const char *status, const char *parameters)
{
    const int id = 2 * file->entries + 1, first = file->records + 1;
    const size_t length = strlen(parameters);
    for (size_t at = 0; at < length; at += 64)
        sprintf(file->data + strlen(file->data), "%-64.64s%8dP%7d\n", parameters + at, id,
                ++file->records);
    sprintf(file->directory + strlen(file->directory),
            "%8d%8d%8d%8d%8d%8d%8d%8d%8sD%7d\n%8d%8d%8d%8d%8d%8s%8s%8s%8dD%7d\n", type, first,
            0, 0, 0, 0, transform, 0, status, id, type, 0, colour, file->records - first + 1,
            form, "", "", "", 0, id + 1);
    file->entries++;
    return id;
}

/* The whole text with this global section. */
static inline const char *iges_end(iges_text *file, const char *global)
{
    int records = 0;
    char *text = file->text;
    sprintf(text, "%-72sS%7d\n", "hand-made", 1);
    for (size_t at = 0; at < strlen(global); at += 72)
        sprintf(text + strlen(text), "%-72.72sG%7d\n", global + at, ++records);
    strcat(text, file->directory);
    strcat(text, file->data);
    sprintf(text + strlen(text), "S%7dG%7dD%7dP%7d%40sT%7d\n", 1, records, 2 * file->entries,
            file->records, "", 1);
    return text;
}

/* A file of one entity. */
static inline const char *iges_one(int type, const char *parameters)
{
    iges_text file = iges_begin();
    iges_add(&file, type, 0, 0, 0, "00000000", parameters);
    return iges_end(&file, IGES_GLOBAL);
}

/* A good line and a bad entity: the line must be read, the other be left out with these words.
 */
static inline void iges_check_left_out(iges_text *file, const char *words)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    iges_add(file, 110, 0, 0, 0, "00000000", IGES_LINE);
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(iges_end(file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    CHECK_MESSAGE("1 of 2 entities are left out");
    CHECK_INT(batten_model_count(model), 1);
    if (batten_notes_dropped(notes) == 0 && !has_note(notes, words))
        CHECK_TEXT(batten_notes_count(notes) > 1 ? batten_notes_at(notes, 1)->text : "no note",
                   words);
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* The file must be partly read, with a note that has these words. */
static inline void iges_check_partly(iges_text *file, const char *words)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(20, &notes));
    CHECK_STATUS(read_text(iges_end(file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model),
                 BATTEN_PARTLY_READ);
    if (batten_notes_dropped(notes) == 0)
        CHECK(has_note(notes, words));
    batten_notes_free(notes);
    batten_model_unref(model);
}

/* Read with one warning, of the first object, which has neither colour nor layer: where it is and what it says. */
static inline void iges_check_wrong(iges_text *file, const char *line, int where,
                                    const char *words)
{
    batten_model *model = NULL;
    batten_notes *notes = NULL;
    CHECK_OK(batten_notes_create(10, &notes));
    CHECK_OK(read_text(iges_end(file, IGES_GLOBAL), BATTEN_FORMAT_AUTO, notes, &model));
    CHECK(!batten_model_object(model, 0)->has_colour);
    CHECK_TEXT(batten_model_object(model, 0)->layer, "");
    if (!batten_notes_dropped(notes)) {
        int first = 0;
        while (batten_notes_at(notes, first)->is_remark)
            first++;
        const batten_note *note = batten_notes_at(notes, first);
        CHECK_INT(count_warnings(notes), 1);
        CHECK_TEXT(note->text, words);
        CHECK_CONTAINS(note->entity, line);
        CHECK_INT(note->line, where);
    }
    batten_notes_free(notes);
    batten_model_unref(model);
}

#endif
