/* The grammar of ISO 10303-21 over a stretch of text, byte by byte. */
#ifndef BAT_STEP_SCAN_H
#define BAT_STEP_SCAN_H
#include "exchange/step/text/instances.h"

/* Text that is gone through for the first time: nothing about it is known yet. */
typedef struct {
    const char *data;
    size_t size;
    int nesting;         /* at most so many brackets in one another */
    size_t string_bytes; /* at most so many in a string */
    /* What is wrong, and where; NULL while nothing is: */
    const char *problem;
    size_t at;
    size_t far; /* up to where it was looked */
    /* The last string begun in this statement, when it runs over the end of a line; else 0. */
    size_t string;
    /* What was borne with, and where it was met first; SIZE_MAX when it was not: */
    size_t lower_case, broken_string, bare_point;
} bat_step_scanner;

/* Bytes of classes; a table, for speed. */
enum { BAT_STEP_BLANK = 1, BAT_STEP_DIGIT = 2, BAT_STEP_LETTER = 4, BAT_STEP_LOWER = 8 };
extern const unsigned char bat_step_class[256];

static inline bool bat_step_in(char c, int classes)
{
    return (bat_step_class[(unsigned char)c] & classes) != 0;
}

/* The first place from `at` on behind blanks and comments; `size` at the end, and when a
 * comment has none: then *unfinished is where it begins. */
size_t bat_step_blank(const char *data, size_t size, size_t at, size_t *unfinished);

/* Each moves *at behind what it reads, or says what is wrong and is false. */

bool bat_step_scan_keyword(bat_step_scanner *scanner, size_t *at);
/* #digits */
bool bat_step_scan_id(bat_step_scanner *scanner, size_t *at, uint64_t *id);
/* One byte, after blanks. */
bool bat_step_scan_byte(bat_step_scanner *scanner, size_t *at, char byte, const char *problem);
/* "(values)", brackets in brackets. */
bool bat_step_scan_list(bat_step_scanner *scanner, size_t *at);
/* Blanks and comments; false when a comment has no end. */
bool bat_step_scan_blank(bat_step_scanner *scanner, size_t *at);

/* Of text that was gone through: the end of the token, string or list at `at`. */
size_t bat_step_token_end(const char *data, size_t size, size_t at);
size_t bat_step_item_end(const char *data, size_t size, size_t at);

#endif
