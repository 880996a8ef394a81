#ifndef BATTEN_BASE_H
#define BATTEN_BASE_H
/**
 * @file
 * What everything else stands on: statuses, the message of the last failure, memory.
 *
 * A function that can fail returns a `batten_status`. When it fails, its outputs are as they
 * were before the call, and `batten_message()` has one sentence that says what was wrong, with
 * the numbers in it. The library never prints, exits or aborts.
 */
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define BATTEN_API __attribute__((visibility("default")))
#ifdef __MINGW32__ /* its plain printf is that of an old Windows, without %zu */
#define BATTEN_PRINTF(text, first) __attribute__((format(gnu_printf, text, first)))
#else
#define BATTEN_PRINTF(text, first) __attribute__((format(printf, text, first)))
#endif
#else
#define BATTEN_API
#define BATTEN_PRINTF(text, first)
#endif

#define BATTEN_VERSION_MAJOR 0
#define BATTEN_VERSION_MINOR 1
#define BATTEN_VERSION_PATCH 0

/** Highest degree of a curve or surface. */
#define BATTEN_MAX_DEGREE 25

/* The one table of statuses: name, text. */
#define BATTEN_STATUS_TABLE(ROW)                                  \
    ROW(OK, "done")                                               \
    ROW(BAD_ARGUMENT, "an argument is not allowed")               \
    ROW(NOT_FINITE, "a number is not finite")                     \
    ROW(BAD_DEGREE, "the degree is not allowed")                  \
    ROW(BAD_KNOTS, "the knots are not allowed")                   \
    ROW(BAD_WEIGHT, "a weight is not positive")                   \
    ROW(TOO_FEW_POINTS, "there are too few points")               \
    ROW(COINCIDENT, "points coincide that must be apart")         \
    ROW(NOT_INCREASING, "values do not increase")                 \
    ROW(OUT_OF_DOMAIN, "a parameter is outside the domain")       \
    ROW(SINGULAR_HERE, "the shape is singular here")              \
    ROW(SINGULAR_SYSTEM, "the equations have no unique solution") \
    ROW(NOT_COMPATIBLE, "the inputs do not fit together")         \
    ROW(TOLERANCE_NOT_MET, "the tolerance was not met")           \
    ROW(OVERFLOW, "a number became too large")                    \
    ROW(TOO_LARGE, "a limit on size is exceeded")                 \
    ROW(OUT_OF_MEMORY, "memory is exhausted")                     \
    ROW(INCOMPLETE, "the work budget ended before the work")      \
    ROW(CANCELLED, "cancelled")                                   \
    ROW(NOT_FOUND, "not found")                                   \
    ROW(FILE_ERROR, "the system refused a file operation")        \
    ROW(BAD_FORMAT, "the text is not in the expected format")     \
    ROW(PARTLY_READ, "only a part could be read")                 \
    ROW(UNSUPPORTED, "not supported")

#define BATTEN_STATUS_ENUM(name, text) BATTEN_##name,
typedef enum batten_status {
    BATTEN_STATUS_TABLE(BATTEN_STATUS_ENUM) BATTEN_STATUS_COUNT
} batten_status;
#undef BATTEN_STATUS_ENUM

/** The name of a status, as in the header but without the prefix: "BAD_KNOTS". */
BATTEN_API const char *batten_status_name(batten_status status);

/** What a status means, in a few words; the details are in batten_message(). */
BATTEN_API const char *batten_status_text(batten_status status);

/** One sentence about the last failure of this thread; "" before the first. Valid until the
 * next failure of the same thread. */
BATTEN_API const char *batten_message(void);

/** "0.1.0". */
BATTEN_API const char *batten_version(void);

/**
 * Where all memory of the library comes from. `resize` is called as realloc would be, with
 * `memory == NULL` for a new block; `release` never with NULL. Both must be thread safe.
 */
typedef struct batten_allocator {
    void *(*resize)(void *user, void *memory, size_t bytes);
    void (*release)(void *user, void *memory);
    void *user;
} batten_allocator;

/** Install an allocator, or the default one with NULL. Call it before anything is allocated. */
BATTEN_API void batten_set_allocator(const batten_allocator *allocator);

/* ---- for those who write further libraries upon the kernel ---- */

/**
 * Keep a sentence as this thread's message and return `status`: `return batten_fail(...)`.
 *
 * @param status  any but BATTEN_OK
 * @param format  as printf
 * @return the status given, so that a function can end with it
 *
 * Cost: one formatted line; no allocation.
 */
BATTEN_API batten_status batten_fail(batten_status status, const char *format, ...)
    BATTEN_PRINTF(2, 3);

/** Zeroed memory for `count` items of `size` bytes; NULL, and the message, when the product
 * does not fit or memory is exhausted. `count == 0` gives a block that may be released. */
BATTEN_API void *batten_array(size_t count, size_t size);

/** The same for `count_u * count_v` items of `size` bytes. */
BATTEN_API void *batten_array3(size_t count_u, size_t count_v, size_t size);

/**
 * Resize a block of batten_array (or NULL) to `count` items; new bytes are not zeroed. On
 * failure NULL, and the old block is untouched.
 *
 * @param memory  from batten_array, or NULL
 * @param count  items
 * @param[out] size  of an item, bytes
 */
BATTEN_API void *batten_resize(void *memory, size_t count, size_t size);

/** Give back memory that the library handed over; NULL is welcome. */
BATTEN_API void batten_release(void *memory);
/**
 * Passed to every routine whose work depends on data; NULL means one thread and no questions.
 * The result has the same bits for any number of threads. The callbacks are called from the
 * thread that made the call, and from no other.
 */
typedef struct batten_job {
    size_t size;         /**< sizeof(batten_job), set by BATTEN_JOB */
    int thread_count;    /**< 1, or more; 0 means as many as there are processors */
    uint64_t work_limit; /**< 0 for none; else about this many elementary steps, then the
                              routine ends with BATTEN_INCOMPLETE */
    bool (*is_cancelled)(void *user); /**< may be NULL; true ends with BATTEN_CANCELLED */
    void (*progress)(void *user, double fraction, const char *what); /**< may be NULL */
    void *user;
} batten_job;

#ifdef __cplusplus
#define BATTEN_JOB                                          \
    batten_job                                              \
    {                                                       \
        sizeof(batten_job), 1, 0, nullptr, nullptr, nullptr \
    }
#else
#define BATTEN_JOB ((batten_job){.size = sizeof(batten_job), .thread_count = 1})
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

/**
 * An empty list of notes; release with batten_notes_free.
 *
 * @param limit  how many are kept, 0 or more
 * @param[out] out  the result; as it was when the function fails
 * @return BATTEN_OK, BAD_ARGUMENT, OUT_OF_MEMORY
 *
 * Cost: constant; memory grows with the notes that are kept, up to the limit.
 */
BATTEN_API batten_status batten_notes_create(int limit, batten_notes **out);
/** Release notes; NULL is welcome. */
BATTEN_API void batten_notes_free(batten_notes *notes);

/**
 * Add one; NULL notes and lack of memory are borne silently (the latter is counted).
 * @param notes  NULL is welcome
 * @param file, entity  copied; NULL counts as ""
 * @param line  from 1; 0 when unknown
 * @param format  as printf
 */
BATTEN_API void batten_notes_add(batten_notes *notes, const char *file, int line,
                                 const char *entity, const char *format, ...)
    BATTEN_PRINTF(5, 6);

/**
 * The same, as a remark: something worth knowing but not a warning.
 *
 * @param notes  NULL is welcome
 * @param file, entity  copied; NULL counts as ""
 * @param line  from 1; 0 when unknown
 * @param format  as printf
 */
BATTEN_API void batten_notes_remark(batten_notes *notes, const char *file, int line,
                                    const char *entity, const char *format, ...)
    BATTEN_PRINTF(5, 6);

/** How many notes are kept.
 *
 * @param notes  any list
 */
BATTEN_API int batten_notes_count(const batten_notes *notes);
/**
 * How many notes were dropped because they were beyond the limit.
 *
 * @param notes  any list
 */
BATTEN_API int batten_notes_dropped(const batten_notes *notes);
/**
 * One of the notes that are kept; borrowed.
 *
 * @param notes  any list
 * @param index  from 0, below batten_notes_count
 */
BATTEN_API const batten_note *batten_notes_at(const batten_notes *notes, int index);

#ifdef __cplusplus
}
#endif
#endif
