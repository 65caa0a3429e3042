// SPDX-License-Identifier: Apache-2.0
#ifndef DORSUM_FIRMWARE_LINE_H
#define DORSUM_FIRMWARE_LINE_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

// One line of the protocol (docs/protocol.md), both ways: reading commands and writing replies. Knows nothing
// of the hardware, so that the host's compiler can build and fuzz it as well.

#define LINE_CAPACITY 64  // of a line without its newline; the longest of either side fits

enum verb { VERB_HELLO, VERB_SET, VERB_GET, VERB_LIMITS, VERB_OFF };

enum line_fault {
  LINE_FINE,
  LINE_DAMAGED,  // no frame, or its checksum is wrong: nothing in it can be believed
  LINE_STRANGE,  // undamaged, but no command that we know; session and sequence are valid
};

struct command {
  uint16_t session, sequence;
  enum verb verb;
  uint8_t protocol;           // HELLO
  uint16_t nonce;             // HELLO
  uint16_t channels;          // SET
  bool has_limits;            // LIMITS: false asks, true sets
  uint32_t laser_ms, led_ms;  // LIMITS
};

// CRC-16/CCITT-FALSE: polynomial 1021, start FFFF, most significant bit first.
uint16_t line_crc(const char* text, uint8_t length);

// Reads a line without its newline.
enum line_fault line_read(const char* text, uint8_t length, struct command* command);

// Builds a reply in a buffer of LINE_CAPACITY + 1. What does not fit is left out and makes line_end() return
// 0.
struct line_writer {
  char* text;
  uint8_t length;
  bool full;
};
void line_begin(struct line_writer* writer, char* text, uint16_t session, uint16_t sequence);
void line_word(struct line_writer* writer, const char* word);  // after a space
void line_letter(struct line_writer* writer, char letter);
void line_hex(struct line_writer* writer, uint32_t value, uint8_t digits);
// Adds checksum and newline; the number of bytes to send.
uint8_t line_end(struct line_writer* writer);

#ifdef __cplusplus
}
#endif

#endif
