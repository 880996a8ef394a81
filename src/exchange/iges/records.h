/*
 * The 80-column records of an IGES file, its global parameters, its directory, and the
 * parameters of an entity as tokens. What they mean is for entities.c.
 */
#ifndef BAT_IGES_RECORDS_H
#define BAT_IGES_RECORDS_H
#include "exchange/input.h"

/* One parameter: empty, a string, or the text of a number. */
typedef struct {
    bat_span text;
    bool is_string;
} bat_iges_token;

/* An entry of the directory. */
typedef struct {
    int id;                                         /* the odd number of its first record */
    int type, form, data, level, transform, colour; /* as they stand in its fields */
    int hidden, subordinate, use;                   /* of its status */
    int subscript;
    char label[9];
    int line;       /* of the file */
    bool is_broken; /* a field could not be read */
} bat_iges_entry;

/* A record of the parameter section. */
typedef struct {
    int number; /* its sequence number, or its place when the numbers are no good */
    int line;
    bool is_damaged;
} bat_iges_data;

typedef struct {
    bat_input *input;
    char delimiter, terminator;
    bat_list global;    /* of char: columns 1-72 of the global records */
    bat_list directory; /* the records of the directory */
    bat_list entries;   /* of bat_iges_entry, with rising ids */
    bat_list data;      /* of bat_iges_data */
    bat_list text;      /* of char: columns 1-64 of each of them */
    bat_list tokens;    /* of bat_iges_token: those of the last bat_iges_tokens */
    size_t tokenised;   /* characters of `text` that were gone through so far */
    bool has_start, has_end;
} bat_iges_file;

/* Take the file apart. */
batten_status bat_iges_begin(bat_input *input, bat_iges_file *file);
void bat_iges_end(bat_iges_file *file);
/* The global parameters from the third on. */
batten_status bat_iges_global(bat_iges_file *file);
/* The parameters of an entry, its type first. BAD_FORMAT, with a message for a note, when they
 * cannot be told apart. */
batten_status bat_iges_tokens(bat_iges_file *file, const bat_iges_entry *entry);

/* Numbers as IGES writes them; an empty one is 0. BAD_FORMAT with a message that names `index`.
 */
batten_status bat_iges_real(const bat_iges_file *file, size_t index, double *value);
batten_status bat_iges_integer(const bat_iges_file *file, size_t index, int *value);

#endif
