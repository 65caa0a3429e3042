// SPDX-License-Identifier: Apache-2.0
#include "line.h"

#include <string.h>

#include "config.h"

uint16_t line_crc(const char* text, uint8_t length) {
  uint16_t crc = 0xFFFF;
  for (uint8_t i = 0; i < length; ++i) {
    crc ^= (uint16_t)((uint16_t)(uint8_t)text[i] << 8);
    for (uint8_t bit = 0; bit < 8; ++bit) {
      crc = (uint16_t)((crc & 0x8000u) ? (uint16_t)(crc << 1) ^ 0x1021u : (uint16_t)(crc << 1));
    }
  }
  return crc;
}

// Where reading stands in a line; `good` turns false for good at the first thing that is not as it must be.
struct reader {
  const char* text;
  uint8_t left;
  bool good;
};

static void read_char(struct reader* reader, char wanted) {
  if (reader->left == 0 || *reader->text != wanted) {
    reader->good = false;
    return;
  }
  ++reader->text;
  --reader->left;
}

// Exactly so many digits, capitals only: each message has one spelling.
static uint32_t read_hex(struct reader* reader, uint8_t digits) {
  if (reader->left < digits) reader->good = false;
  if (!reader->good) return 0;
  uint32_t value = 0;
  for (uint8_t i = 0; i < digits; ++i) {
    const char c = reader->text[i];
    uint8_t digit = 0;
    if (c >= '0' && c <= '9') {
      digit = (uint8_t)(c - '0');
    } else if (c >= 'A' && c <= 'F') {
      digit = (uint8_t)(c - 'A' + 10);
    } else {
      reader->good = false;
      return 0;
    }
    value = value << 4 | digit;
  }
  reader->text += digits;
  reader->left = (uint8_t)(reader->left - digits);
  return value;
}

static uint32_t read_argument(struct reader* reader, uint8_t digits) {
  read_char(reader, ' ');
  return read_hex(reader, digits);
}

static bool skip_word(struct reader* reader, const char* word) {
  const uint8_t length = (uint8_t)strlen(word);
  if (reader->left < length || memcmp(reader->text, word, length) != 0) return false;
  if (reader->left > length && reader->text[length] != ' ') return false;
  reader->text += length;
  reader->left = (uint8_t)(reader->left - length);
  return true;
}

static bool read_verb(struct reader* reader, struct command* command) {
  if (skip_word(reader, "SET")) {
    command->verb = VERB_SET;
    command->channels = (uint16_t)read_argument(reader, 4);
  } else if (skip_word(reader, "GET")) {
    command->verb = VERB_GET;
  } else if (skip_word(reader, "OFF")) {
    command->verb = VERB_OFF;
  } else if (skip_word(reader, "LIMITS")) {
    command->verb = VERB_LIMITS;
    command->has_limits = reader->left > 0;
    if (command->has_limits) {
      command->laser_ms = read_argument(reader, 8);
      command->led_ms = read_argument(reader, 8);
    }
  } else if (skip_word(reader, "HELLO")) {
    command->verb = VERB_HELLO;
    command->protocol = (uint8_t)read_argument(reader, 2);
    command->nonce = (uint16_t)read_argument(reader, 4);
    // Another protocol may say more in its greeting; it must get our number in answer.
    if (reader->good && command->protocol != DORSUM_PROTOCOL) reader->left = 0;
  } else {
    return false;
  }
  return reader->good && reader->left == 0;
}

enum line_fault line_read(const char* text, uint8_t length, struct command* command) {
  memset(command, 0, sizeof *command);
  if (length < 5 || length > LINE_CAPACITY) return LINE_DAMAGED;
  const uint8_t body = (uint8_t)(length - 5);
  struct reader end = {text + body, 5, true};
  read_char(&end, '*');
  const uint16_t crc = (uint16_t)read_hex(&end, 4);
  if (!end.good || crc != line_crc(text, body)) return LINE_DAMAGED;

  struct reader reader = {text, body, true};
  read_char(&reader, '>');
  command->session = (uint16_t)read_hex(&reader, 4);
  read_char(&reader, ' ');
  command->sequence = (uint16_t)read_hex(&reader, 4);
  read_char(&reader, ' ');
  if (!reader.good) return LINE_DAMAGED;
  return read_verb(&reader, command) ? LINE_FINE : LINE_STRANGE;
}

static void write_char(struct line_writer* writer, char c) {
  if (writer->length >= LINE_CAPACITY) {
    writer->full = true;
    return;
  }
  writer->text[writer->length++] = c;
}

static void write_digits(struct line_writer* writer, uint32_t value, uint8_t digits) {
  while (digits-- > 0) write_char(writer, "0123456789ABCDEF"[value >> (4 * digits) & 0xFu]);
}

void line_begin(struct line_writer* writer, char* text, uint16_t session, uint16_t sequence) {
  writer->text = text;
  writer->length = 0;
  writer->full = false;
  write_char(writer, '<');
  write_digits(writer, session, 4);
  line_hex(writer, sequence, 4);
}

void line_word(struct line_writer* writer, const char* word) {
  write_char(writer, ' ');
  while (*word != 0) write_char(writer, *word++);
}

void line_letter(struct line_writer* writer, char letter) {
  write_char(writer, ' ');
  write_char(writer, letter);
}

void line_hex(struct line_writer* writer, uint32_t value, uint8_t digits) {
  write_char(writer, ' ');
  write_digits(writer, value, digits);
}

uint8_t line_end(struct line_writer* writer) {
  const uint16_t crc = line_crc(writer->text, writer->length);
  write_char(writer, '*');
  write_digits(writer, crc, 4);
  if (writer->full) return 0;
  writer->text[writer->length++] = '\n';
  return writer->length;
}
