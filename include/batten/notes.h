#ifndef BATTEN_NOTES_H
#define BATTEN_NOTES_H
/**
 * @file
 * What readers and writers have to say about their input, as a list.
 */
#include <batten/base.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct batten_note {
    const char *file;   /**< may be "" */
    int line;           /**< from 1; 0 when it has no place */
    const char *entity; /**< "#317 B_SPLINE_CURVE", "station 4"; may be "" */
    const char *text;   /**< what is wrong, with the numbers, and what was done */
    bool is_remark;     /**< nothing is wrong: it says what was found or done */
} batten_note;

/** A list of notes, at most `limit`, then counted. */
typedef struct batten_notes batten_notes;

/** @param limit  how many are kept, 0 or more */
BATTEN_API batten_status batten_notes_create(int limit, batten_notes **out);
BATTEN_API void batten_notes_free(batten_notes *notes);

/** Add one; NULL notes and lack of memory are borne silently (the latter is counted).
 * @param file, entity  copied; NULL counts as "" */
BATTEN_API void batten_notes_add(batten_notes *notes, const char *file, int line,
                                 const char *entity, const char *format, ...)
    BATTEN_PRINTF(5, 6);

/** The same, as a remark: something worth knowing that is no warning. */
BATTEN_API void batten_notes_remark(batten_notes *notes, const char *file, int line,
                                    const char *entity, const char *format, ...)
    BATTEN_PRINTF(5, 6);

BATTEN_API int batten_notes_count(const batten_notes *notes);   /**< those that are kept */
BATTEN_API int batten_notes_dropped(const batten_notes *notes); /**< those beyond the limit */
BATTEN_API const batten_note *batten_notes_at(const batten_notes *notes, int index);

#ifdef __cplusplus
}
#endif
#endif
