#include "config/kiosk_config.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"

namespace docent::config::kiosk_config_test {
namespace {

using test::TemporaryFolder;

Loaded<KioskConfig> loaded_from(const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "kiosk.toml") << text;
  return load_kiosk_config(folder.path() / "kiosk.toml");
}

TEST(KioskConfig, IsThatOfANewDeviceWhereThereIsNoFile) {
  const auto loaded = load_kiosk_config("no/such/kiosk.toml");

  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_TRUE(loaded.diagnostics.empty());
  EXPECT_EQ(loaded.value->idle_reset.count(), 60);
  EXPECT_EQ(loaded.value->content, "/var/lib/docent/museum.db");
}

TEST(KioskConfig, KnowsEveryDisplayByItsNameAndSaysAllNamesOfAnother) {
  std::string names;
  for (const auto& [name, kind] : display_kinds) {
    const auto loaded = loaded_from("display = \"" + std::string(name) + "\"\n");
    ASSERT_TRUE(loaded.value.has_value()) << name;
    EXPECT_EQ(loaded.value->display, kind);
    names += names.empty() ? "" : ", ";
    names += name;
  }
  const auto loaded = loaded_from("display = \"wayland\"\n");
  ASSERT_EQ(loaded.diagnostics.size(), 1U);
  EXPECT_THAT(loaded.diagnostics[0].message, testing::HasSubstr(names));
}

TEST(KioskConfig, TakesWhatAnOperatorWrote) {
  const auto loaded = loaded_from(
      "idle_reset = 90\ntext_scale = 1.5\nrotate = 270\nsize = \"1080x1920\"\ndisplay = \"kms\"\n");

  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_TRUE(loaded.diagnostics.empty());
  EXPECT_EQ(loaded.value->idle_reset.count(), 90);
  EXPECT_EQ(loaded.value->text_scale, 1.5);
  EXPECT_EQ(loaded.value->rotate, 270);
  EXPECT_EQ(loaded.value->width, 1080);
  EXPECT_EQ(loaded.value->height, 1920);
  EXPECT_EQ(loaded.value->display, DisplayKind::Kms);
}

TEST(KioskConfig, RefusesWhatNoDeviceCanDo) {
  for (const char* line :
       {"idle_reset = 5",        "idle_reset = 601",         "idle_reset = 60.5",
        "text_scale = 3.0",      "text_scale = nan",         "rotate = 45",
        "size = \"1920x1080@\"", "size = \"1920x1080@999\"", "screen_on = \"mornings\"",
        "theme = \"dark\"",      "night = \"late\"",         "mirror = 1",
        "size = \"big\"",        "size = \"1920x\"",         "size = \"0x0\"",
        "display = \"wayland\"", "brightness = 1",           "visitors = 0",
        "visitors = 9",          "mount_height = 20",        "visitors = \"many\""}) {
    const auto loaded = loaded_from(line);

    EXPECT_EQ(loaded.diagnostics.size(), 1U) << line;
    for (const Diagnostic& diagnostic : loaded.diagnostics) EXPECT_EQ(diagnostic.line, 1U) << line;
  }
}

TEST(KioskConfig, SharesALargeScreenUnlessItIsToldNotTo) {
  const auto visitors_of = [](const std::string& text) {
    const KioskConfig config = *loaded_from(text).value;
    return visitors(config, screen_inches(config, std::nullopt));
  };

  EXPECT_EQ(visitors_of("screen_inches = 24"), 1);
  EXPECT_EQ(visitors_of("screen_inches = 55"), 8);
  EXPECT_EQ(visitors_of("screen_inches = 55\nvisitors = 1"), 1);
  EXPECT_EQ(visitors_of("screen_inches = 32\nvisitors = 3"), 3);
}

TEST(KioskConfig, KnowsAtWhichEdgesOfATableVisitorsStand) {
  const auto loaded = loaded_from("sides = [\"bottom\", \"top\", \"left\", \"top\"]");
  ASSERT_TRUE(loaded.value && loaded.diagnostics.empty());
  EXPECT_EQ(loaded.value->sides, (std::vector{GlassEdge::Bottom, GlassEdge::Top, GlassEdge::Left}));
  EXPECT_TRUE(loaded_from("").value->sides.empty());

  const auto wrong = loaded_from("sides = [\"botom\"]");
  ASSERT_EQ(wrong.diagnostics.size(), 1U);
  EXPECT_EQ(wrong.diagnostics[0].hint, "write \"bottom\"");
}

TEST(KioskConfig, BelievesTheScreensOwnSizeUnlessTheOperatorSaysAnother) {
  const KioskConfig silent = *loaded_from("").value,
                    told = *loaded_from("screen_inches = 32").value;

  EXPECT_EQ(screen_inches(silent, 54.6), 54.6);
  EXPECT_EQ(screen_inches(silent, std::nullopt), 24);
  EXPECT_EQ(screen_inches(told, 54.6), 32);
  EXPECT_EQ(visitors(silent, 54.6), 8);
}

TEST(KioskConfig, TakesWhatAnOperatorSaysOfTheScreens) {
  const auto loaded = loaded_from(
      "size = \"1920x1080@50\"\noutput = \"HDMI-A-2\"\nmirror = true\nreduced_motion = true\n"
      "same_key_delay = 0.5\n"
      "pixel_shift = true\nscreen_on = \"Mo-Fr 08:30-18:00\"\n"
      "theme = \"night\"\nnight = \"Mo-Su 18:00-22:00\"\n");

  EXPECT_TRUE(loaded.diagnostics.empty());
  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_EQ(loaded.value->width, 1920);
  EXPECT_EQ(loaded.value->refresh, 50);
  EXPECT_EQ(loaded.value->output, "HDMI-A-2");
  EXPECT_TRUE(loaded.value->mirror);
  EXPECT_TRUE(loaded.value->reduced_motion);
  EXPECT_EQ(loaded.value->same_key_delay, 0.5);
  EXPECT_TRUE(loaded.value->pixel_shift);
  ASSERT_TRUE(loaded.value->screen_on.has_value());
  EXPECT_TRUE(holds(*loaded.value->screen_on, 0, 9 * 60));
  EXPECT_FALSE(holds(*loaded.value->screen_on, 6, 9 * 60));
  EXPECT_TRUE(loaded.value->is_night);
  ASSERT_TRUE(loaded.value->night.has_value());
  EXPECT_TRUE(holds(*loaded.value->night, 3, 20 * 60));
}

TEST(KioskConfig, NamesKeysBesideItAndNoMoreThanTwo) {
  const auto loaded = loaded_from("keys = [\"a.pub\", \"/etc/docent/b.pub\"]");
  ASSERT_TRUE(loaded.value && loaded.diagnostics.empty());
  ASSERT_EQ(loaded.value->keys.size(), 2U);
  EXPECT_TRUE(loaded.value->keys[0].is_absolute());
  EXPECT_EQ(loaded.value->keys[0].filename(), "a.pub");
  EXPECT_EQ(loaded.value->keys[1], "/etc/docent/b.pub");

  EXPECT_FALSE(loaded_from("keys = [\"a\", \"b\", \"c\"]").diagnostics.empty());
}

TEST(KioskConfig, ReadsTheOneThatShips) {
  const auto file = test::source_dir() / "config/kiosk.toml";
  ASSERT_TRUE(std::filesystem::exists(file));

  EXPECT_TRUE(load_kiosk_config(file).diagnostics.empty());
}

TEST(KioskConfig, KnowsTheKeypadsThatStaffNamed) {
  const auto loaded = loaded_from(
      "idle_reset = 90\n[[keypad]]\ndevice = \"04e7:0022\"\n[[keypad]]\ndevice = \"1209:0001\"\n"
      "descriptor = \"0123456789abcdef\"\n");

  ASSERT_TRUE(loaded.value.has_value());
  EXPECT_TRUE(loaded.diagnostics.empty());
  EXPECT_EQ(loaded.value->idle_reset.count(), 90);
  ASSERT_EQ(loaded.value->keypads.size(), 2U);
  EXPECT_EQ(loaded.value->keypads[0].device.value, "04e7:0022");
  EXPECT_FALSE(loaded.value->keypads[0].descriptor.given);
  EXPECT_EQ(loaded.value->keypads[1].descriptor.value, "0123456789abcdef");
}

TEST(KioskConfig, KnowsWhatTheKeysOfAKeypadMean) {
  const auto loaded =
      loaded_from("[[keypad]]\ndevice = \"2047:09d0\"\nkeys.F23 = \"LEFT\"\nkeys.F24 = \"7\"\n");

  EXPECT_TRUE(loaded.diagnostics.empty());
  ASSERT_TRUE(loaded.value.has_value());
  const auto& keys = loaded.value->keypads.at(0).keys.value;
  EXPECT_EQ(keys.at("F23").value, "LEFT");
  EXPECT_EQ(keys.at("F24").value, "7");
}

TEST(KioskConfig, SaysWhichKeyThereIsNot) {
  const auto told = [](const std::string& line) {
    const auto loaded = loaded_from("[[keypad]]\ndevice = \"2047:09d0\"\n" + line + "\n");
    return loaded.diagnostics.size() == 1 && loaded.diagnostics[0].line == 3
               ? loaded.diagnostics[0].message + " | " + loaded.diagnostics[0].hint
               : std::string("not told in its line, once");
  };

  EXPECT_THAT(told("keys.F25 = \"LEFT\""),
              testing::HasSubstr("'F25' is no key's name | docent hid"));
  EXPECT_THAT(told("keys.F23 = \"links\""), testing::HasSubstr("'links' is no key that a kiosk"));
  EXPECT_THAT(told("keys.F23 = \"F13\""), testing::HasSubstr("write UP, DOWN"));
  EXPECT_THAT(told("keys = \"LEFT\""), testing::HasSubstr("keys.KEY = "));
}

TEST(KioskConfig, SaysWhereAKeypadIsNotAsTheListTellsIt) {
  const auto message = [](const std::string& text) {
    const auto loaded = loaded_from(text);
    return loaded.diagnostics.empty() ? std::string() : loaded.diagnostics[0].message;
  };

  EXPECT_THAT(message("[[keypad]]\ndevice = \"Elo\"\n"), testing::HasSubstr("04e7:0022"));
  EXPECT_THAT(message("[[keypad]]\ndevice = \"04e7:0022\"\ndescriptor = \"12\"\n"),
              testing::HasSubstr("sixteen"));
  EXPECT_THAT(message("[[keypad]]\ndescriptor = \"0123456789abcdef\"\n"),
              testing::HasSubstr("device"));
  EXPECT_THAT(message("keypad = 3\n"), testing::HasSubstr("[[keypad]]"));
}

TEST(KioskConfig, ReadsWhatSpeechIsHeardFrom) {
  const auto loaded = loaded_from("[sound]\ndevice = \"plughw:1,0\"\nvolume = 0.7\n");

  EXPECT_TRUE(loaded.diagnostics.empty());
  EXPECT_EQ(loaded.value->sound_device, "plughw:1,0");
  EXPECT_EQ(loaded.value->sound_volume, 0.7);
  EXPECT_EQ(loaded_from("").value->sound_device, std::nullopt);
  EXPECT_EQ(loaded_from("").value->sound_volume, 1);

  const auto message = [](const std::string& text) {
    const auto wrong = loaded_from(text);
    return wrong.diagnostics.empty() ? std::string() : wrong.diagnostics[0].message;
  };
  EXPECT_THAT(message("[sound]\nvolume = 11\n"), testing::HasSubstr("volume"));
  EXPECT_THAT(message("[sound]\ndevise = \"x\"\n"), testing::HasSubstr("devise"));
  EXPECT_THAT(message("sound = 3\n"), testing::HasSubstr("[sound]"));
}

TEST(KioskConfig, TakesNoPinThatAnybodyCouldRead) {
  const auto loaded = loaded_from("staff_pin = \"4711\"\n");

  ASSERT_EQ(loaded.diagnostics.size(), 1U);
  EXPECT_THAT(loaded.diagnostics[0].message, testing::HasSubstr("docent pin"));
  EXPECT_EQ(loaded_from("staff_pin = \"$argon2id$v=19$x\"\n").value->staff_pin, "$argon2id$v=19$x");
}

}  // namespace
}  // namespace docent::config::kiosk_config_test
