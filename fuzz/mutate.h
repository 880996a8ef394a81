/* Damage that knows how a format is built: it changes tokens, lines and entities, not only
 * bytes, so that what comes of it gets past the first check of a reader. */
#ifndef FUZZ_MUTATE_H
#define FUZZ_MUTATE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What the mutator has to know of a format. */
typedef struct {
    const char *name;       /* of the target: "step" */
    char end;               /* of a line or an entity */
    char reference;         /* before the number of an entity; 0: any whole number may be one */
    char quote;             /* around strings; 0: none */
    bool is_glued;          /* numbers and letters follow one another without a blank */
    bool has_columns;       /* records of 80 columns with sequence numbers */
    const char *header_end; /* what follows this text is bytes, not text; NULL: all is text;
                               "": either all is, or nothing */
    const char *words;      /* words of the format, one blank between them */
} fuzz_grammar;

/* NULL when there is none of that name. */
const fuzz_grammar *fuzz_grammar_of(const char *name);

/* xorshift64*: equal seeds give equal damage everywhere. */
typedef struct {
    uint64_t state;
} fuzz_random;
fuzz_random fuzz_random_begin(uint64_t seed);
/* 0 .. count - 1; 0 for a count of 0. */
size_t fuzz_random_below(fuzz_random *random, size_t count);

/* Bytes within a capacity: what does not fit is not done. */
typedef struct {
    char *bytes;
    size_t size, capacity;
} fuzz_text;

/* Put other bytes in the place of from .. to. */
bool fuzz_replace(fuzz_text *text, size_t from, size_t to, const char *bytes, size_t count);

/* ---- tokens (tokens.c) ---- */

typedef enum { FUZZ_NUMBER, FUZZ_WORD, FUZZ_REFERENCE, FUZZ_STRING, FUZZ_MARK } fuzz_kind;
typedef struct {
    size_t begin, end;
    fuzz_kind kind;
} fuzz_token;
#define FUZZ_TOKENS 4096
typedef struct {
    fuzz_token tokens[FUZZ_TOKENS];
    size_t items[FUZZ_TOKENS + 1]; /* where lines or entities begin, and the last ends */
    size_t count, item_count;
    size_t text_end; /* where bytes that are no text begin */
} fuzz_tokens;
/* The first FUZZ_TOKENS of a text. */
void fuzz_tokens_of(const fuzz_grammar *grammar, const fuzz_text *text, fuzz_tokens *out);

/* ---- records of 80 columns (columns.c) ---- */

/* One line for each line of the start section, "S..."; one of the global section, "G..."; one
 * for each entity, "D" with its 18 fields, each with a | behind, and its parameters. False for
 * what is not in such records. */
bool fuzz_unfold(const fuzz_text *records, fuzz_text *lines);
/* Such lines as records, with their numbers and pointers to parameters. */
bool fuzz_fold(const fuzz_text *lines, fuzz_text *records);

/* ---- damage (mutate.c) ---- */

/* Change `size` bytes in place once, with room for `most`; returns how many there are then.
 * @param other a text of the same format, of which entities may be taken; NULL for none
 * @param bytes what else changes bytes, as LLVMFuzzerMutate does; NULL for our own */
size_t fuzz_mutate(const fuzz_grammar *grammar, uint8_t *data, size_t size, size_t most,
                   uint64_t seed, const uint8_t *other, size_t other_size,
                   size_t (*bytes)(uint8_t *data, size_t size, size_t most));

#endif
