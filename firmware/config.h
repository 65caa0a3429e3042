// SPDX-License-Identifier: Apache-2.0
#ifndef DORSUM_FIRMWARE_CONFIG_H
#define DORSUM_FIRMWARE_CONFIG_H

// What is fixed when the firmware is built. docs/protocol.md and docs/light-controller.md explain each.

#ifndef DORSUM_PROTOCOL
#define DORSUM_PROTOCOL 1  // 0 to 255; a host of another protocol is refused
#endif
#define DORSUM_FIRMWARE_VERSION "1.0.0"

// 1: a pin that is low lights its light, as in the document's circuit (thesis, section 3.1).
#ifndef DORSUM_INVERTED
#define DORSUM_INVERTED 0
#endif

#define CHANNEL_COUNT 9
#define LASER_CHANNELS 0x00FFu  // channels 0 to 7
#define ALL_CHANNELS 0x01FFu    // and the LEDs, channel 8

#define SILENCE_LIMIT_MS 2000u
#define LASER_LIMIT_MS 10000u
#define LED_LIMIT_MS 600000u

#define BAUD 115200ul

#endif
