// SPDX-License-Identifier: Apache-2.0
#include "controller.h"

#include <string.h>

#include "config.h"

static void all_off(struct controller* self, char why) {
  // The first reason is what the host wants to know.
  if (self->on != 0 || why == WHY_HOST) self->why = why;
  self->on = 0;
}

void controller_begin(struct controller* self, uint16_t wired, char logic, char reset, uint16_t seed) {
  memset(self, 0, sizeof *self);
  self->wired = wired & ALL_CHANNELS;
  self->logic = logic;
  self->reset = reset;
  self->seed = seed;
  self->why = WHY_HOST;
}

uint8_t controller_banner(const struct controller* self, char* reply) {
  struct line_writer writer;
  line_begin(&writer, reply, 0, 0);
  line_word(&writer, "BOOT");
  line_hex(&writer, DORSUM_PROTOCOL, 2);
  line_word(&writer, DORSUM_FIRMWARE_VERSION);
  line_letter(&writer, self->reset);
  return line_end(&writer);
}

// Whatever is wrong, everything goes off.
static uint8_t refuse(struct controller* self, const struct command* command, const char* word, char* reply) {
  all_off(self, WHY_ERROR);
  struct line_writer writer;
  line_begin(&writer, reply, command->session, command->sequence);
  line_word(&writer, "ERR");
  line_word(&writer, word);
  return line_end(&writer);
}

static uint8_t answer_state(const struct controller* self, const struct command* command, char* reply) {
  struct line_writer writer;
  line_begin(&writer, reply, command->session, command->sequence);
  if (command->verb == VERB_LIMITS) {
    line_word(&writer, "LIMITS");
    line_hex(&writer, SILENCE_LIMIT_MS, 8);
    line_hex(&writer, self->laser_limit_ms, 8);
    line_hex(&writer, self->led_limit_ms, 8);
  } else {
    line_word(&writer, "OK");
    line_hex(&writer, self->on, 4);
    line_letter(&writer, self->why);
  }
  return line_end(&writer);
}

static void open_session(struct controller* self, const struct command* command, uint32_t now_ms) {
  // Another number each time, so that a late line of an older session finds none.
  const uint16_t mix[4] = {self->seed, command->nonce, (uint16_t)now_ms, self->session};
  uint16_t session = line_crc((const char*)mix, sizeof mix);
  while (session == 0 || session == self->session) ++session;
  self->seed = (uint16_t)(self->seed + session);
  self->session = session;
  self->in_session = true;
  self->only_greeted = true;
  self->nonce = command->nonce;
  self->sequence = command->sequence;
  self->heard_ms = now_ms;
  self->laser_limit_ms = LASER_LIMIT_MS;
  self->led_limit_ms = LED_LIMIT_MS;
}

static uint8_t greet(struct controller* self, const struct command* command, uint32_t now_ms, char* reply) {
  all_off(self, WHY_HOST);
  if (command->protocol != DORSUM_PROTOCOL) {
    self->in_session = false;
    struct line_writer writer;
    line_begin(&writer, reply, command->session, command->sequence);
    line_word(&writer, "ERR");
    line_word(&writer, "VERSION");
    line_hex(&writer, DORSUM_PROTOCOL, 2);
    line_word(&writer, DORSUM_FIRMWARE_VERSION);
    return line_end(&writer);
  }
  // The same greeting again is a host that missed the answer.
  const bool repeated = self->in_session && self->only_greeted && self->nonce == command->nonce &&
                        self->sequence == command->sequence;
  if (!repeated) open_session(self, command, now_ms);
  struct line_writer writer;
  line_begin(&writer, reply, self->session, command->sequence);
  line_word(&writer, "HI");
  line_hex(&writer, DORSUM_PROTOCOL, 2);
  line_hex(&writer, command->nonce, 4);
  line_word(&writer, DORSUM_FIRMWARE_VERSION);
  line_hex(&writer, CHANNEL_COUNT, 2);
  line_hex(&writer, self->wired, 4);
  line_letter(&writer, self->logic);
  line_letter(&writer, self->reset);
  return line_end(&writer);
}

static uint8_t obey(struct controller* self, const struct command* command, uint32_t now_ms, char* reply) {
  switch (command->verb) {
    case VERB_SET:
      if ((command->channels & (uint16_t)~self->wired) != 0) return refuse(self, command, "CHANNEL", reply);
      self->on = command->channels;
      self->why = self->on != 0 ? WHY_LIT : WHY_HOST;
      self->set_ms = now_ms;
      break;
    case VERB_LIMITS:
      if (command->has_limits) {
        if (command->laser_ms == 0 || command->laser_ms > self->laser_limit_ms || command->led_ms == 0 ||
            command->led_ms > self->led_limit_ms) {
          return refuse(self, command, "LIMIT", reply);
        }
        self->laser_limit_ms = command->laser_ms;
        self->led_limit_ms = command->led_ms;
      }
      break;
    case VERB_GET:
    case VERB_OFF:
    case VERB_HELLO:
      break;
  }
  return answer_state(self, command, reply);
}

static uint8_t take_line(struct controller* self, uint32_t now_ms, char* reply) {
  struct command command;
  const enum line_fault fault = self->damaged ? LINE_DAMAGED : line_read(self->line, self->length, &command);
  if (fault == LINE_DAMAGED) {
    command.session = command.sequence = 0;
    return refuse(self, &command, "DAMAGED", reply);
  }
  if (fault == LINE_STRANGE) return refuse(self, &command, "COMMAND", reply);
  if (command.verb == VERB_OFF) all_off(self, WHY_HOST);  // from whoever, whenever
  if (command.verb == VERB_HELLO) return greet(self, &command, now_ms, reply);
  if (!self->in_session || command.session != self->session) return refuse(self, &command, "SESSION", reply);

  const uint16_t ahead = (uint16_t)(command.sequence - self->sequence);
  // A retry after a lost answer, or a line that came twice: it has been obeyed, and is no sign of life
  // either.
  if (ahead == 0 && !self->only_greeted) return answer_state(self, &command, reply);
  if (ahead == 0 || ahead >= 0x8000u) return refuse(self, &command, "STALE", reply);
  self->sequence = command.sequence;
  self->only_greeted = false;
  self->heard_ms = now_ms;
  return obey(self, &command, now_ms, reply);
}

uint8_t controller_byte(struct controller* self, char byte, bool damaged, uint32_t now_ms, char* reply) {
  if (damaged) {
    self->damaged = true;
    all_off(self, WHY_ERROR);
  }
  if (byte == '\n') {
    const uint8_t sent = self->length > 0 || self->damaged ? take_line(self, now_ms, reply) : 0;
    self->length = 0;
    self->damaged = false;
    return sent;
  }
  if (byte == '>') {  // stands nowhere but at a beginning: the end of the line before it is lost
    if (self->length > 0) all_off(self, WHY_ERROR);
    self->length = 0;
    self->damaged = damaged;
  }
  if (self->length >= LINE_CAPACITY) {
    self->damaged = true;
    all_off(self, WHY_ERROR);
    return 0;
  }
  self->line[self->length++] = byte;
  return 0;
}

void controller_tick(struct controller* self, uint32_t now_ms) {
  if (self->on == 0) return;
  const uint32_t lit_ms = now_ms - self->set_ms;
  if (now_ms - self->heard_ms >= SILENCE_LIMIT_MS) {
    all_off(self, WHY_SILENCE);
  } else if (((self->on & LASER_CHANNELS) != 0 && lit_ms >= self->laser_limit_ms) ||
             ((self->on & (uint16_t)~LASER_CHANNELS) != 0 && lit_ms >= self->led_limit_ms)) {
    all_off(self, WHY_TIME);
  }
}
