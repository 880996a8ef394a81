/* What holds of every reader and writer over the seeds of its corpus in fuzz/corpus: each room
 * asks for its own. */
#ifndef TESTS_EXCHANGE_CORPUS_H
#define TESTS_EXCHANGE_CORPUS_H
#include "exchange/reading.h"

typedef struct {
    batten_format format;
    char (*files)[200]; /* below fuzz/corpus, sorted */
    int count;
} corpus;

/* The files of a folder that were made by hand and have `like` in their names, "" for all. */
corpus corpus_of(batten_format format, const char *folder, const char *like);
corpus corpus_named(batten_format format, const char *const *files, int count);

/* Each number as nan, -inf, 1e400 and 1e-400: the reader says so, or reads the same as before. */
void check_no_number_is_lost(const corpus *c);

/* Each reference of STEP as one to nothing: the reader says so, or reads the same as before. */
void check_no_reference_is_lost(const corpus *c);

/* One allocation that fails, each in turn, or `most` of them evenly: reading says that memory is
 * missing, or reads all the same. */
void check_reading_without_memory(const corpus *c, int most);

/* The same of writing as `to` what is read. */
void check_writing_without_memory(const corpus *c, batten_format to, int most);

#endif
