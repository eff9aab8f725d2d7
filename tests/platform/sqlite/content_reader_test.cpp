#include "platform/sqlite/content_reader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "content/content_error.h"
#include "content/write/content_writer.h"
#include "content/write/replace_file.h"
#include "runtime/model/exhibit/longer_text.h"
#include "runtime/schema/schema.h"
#include "tests/support/small_museum.h"
#include "tests/support/temporary_folder.h"

namespace docent::sqlite::content_reader_test {
namespace {

using test::small_museum;
using test::TemporaryFolder;
using testing::HasSubstr;

/// What the kiosk says about a database file of these bytes.
Error refusal(const std::vector<std::byte>& bytes) {
  const TemporaryFolder folder;
  write::replace_file(folder.path() / "museum.db", bytes);
  const auto museum = load_museum(folder.path() / "museum.db");
  return museum ? Error{.code = Errc::WrongUsage, .what = "was accepted"} : museum.error();
}

TEST(ContentReader, LeavesVideosInTheFileWhereTheyAreAskedForLater) {
  const TemporaryFolder folder;
  Museum museum = small_museum();
  const std::vector<std::byte> bytes(100, std::byte{7});
  museum.images = {{.name = "a.webm", .width = 64, .height = 48, .bytes = bytes},
                   {.name = "b.png", .width = 64, .height = 48, .bytes = bytes},
                   {.name = "c.webm", .width = 64, .height = 48, .bytes = bytes}};
  const auto file = folder.path() / "museum.db";
  write::write_museum(museum, file);
  const auto database = open_database(file);
  ASSERT_TRUE(database.has_value());

  const auto all = read_museum(*database, file);
  const auto light = read_museum(*database, file, Videos::LeaveInFile);

  ASSERT_TRUE(all.has_value() && light.has_value());
  for (std::size_t image = 0; image < 3; ++image) {
    EXPECT_EQ(all->images[image].bytes, bytes);
    EXPECT_EQ(light->images[image].bytes, image == 1 ? bytes : std::vector<std::byte>());
    EXPECT_EQ(light->images[image].name, museum.images[image].name);
  }
}

TEST(ContentReader, GivesBackEveryFieldThatTheWriterStored) {
  const TemporaryFolder folder;
  const Museum museum = small_museum();
  write::write_museum(museum, folder.path() / "museum.db");

  const auto read = load_museum(folder.path() / "museum.db");

  ASSERT_TRUE(read.has_value()) << read.error().what;
  // The writer covers every field (rows.h), so equal files are equal museums.
  EXPECT_EQ(write::encode_museum(*read), write::encode_museum(museum));
  EXPECT_EQ(read->exhibits[0].text.at("zh"), "玉璧。");
  ASSERT_EQ(read->exhibits[0].touches.size(), 1U);
  EXPECT_EQ(read->exhibits[0].touches[0].ready, Vec3(9.5F, 1.75F, -4.25F));
  EXPECT_EQ(read->ambient.entrances, museum.ambient.entrances);
  EXPECT_EQ(read->ambient.look_most, 9.5);
  EXPECT_EQ(read->floors[0].tangent_graphs[1].tangent[0].leave, Vec2(1, 2));
  EXPECT_EQ(read->motion.clips[0].rotation[3].z, 1.0F);
  EXPECT_EQ(read->motion.skeleton.has_rotation, museum.motion.skeleton.has_rotation);
  EXPECT_EQ(read->avatar.inverse_bind[1], Mat4(2));
  ASSERT_EQ(read->avatar.cloth.node.size(), 2U);
  EXPECT_EQ(read->avatar.cloth.node[1].place, Vec3(0, 1, 2));
  EXPECT_EQ(read->avatar.cloth.node[1].above, 0);
  ASSERT_EQ(read->avatar.cloth.collider.size(), 1U);
  EXPECT_EQ(read->avatar.cloth.collider[0].to_radius, 0.25F);
  EXPECT_EQ(read->languages[1].words.at("home"), "البداية");
}

/// The refusal of a database in which one byte was changed.
Error refusal_with_flipped_byte(std::size_t place, std::byte flip) {
  static const std::vector<std::byte> whole = write::encode_museum(small_museum());
  std::vector<std::byte> bytes = whole;
  bytes[place % bytes.size()] ^= flip;
  return refusal(bytes);
}

TEST(ContentReader, RefusesAFileInWhichAnyByteHasChanged) {
  EXPECT_TRUE(rc::check("every flipped byte is noticed", [] {
    const auto place = *rc::gen::inRange<std::size_t>(0, std::size_t{1} << 20);
    const auto flip = static_cast<std::byte>(*rc::gen::inRange(1, 256));

    const Error error = refusal_with_flipped_byte(place, flip);

    RC_ASSERT(exit_code(error.code) == 1);
    RC_ASSERT(error.what.find("museum.db") != std::string::npos);
  }));
}

TEST(ContentReader, LooksAtTheFirstBytesBeforeItReadsGigabytes) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "museum.db";
  std::ofstream(file) << "a film of the opening";
  std::filesystem::resize_file(file, std::uintmax_t{1} << 42U);
  EXPECT_THAT(load_museum(file).error().what, HasSubstr("is not a docent database"));

  write::write_museum(small_museum(), file);
  std::filesystem::resize_file(file, std::uintmax_t{1} << 42U);
  const auto opened = open_database(file, schema::largest_shown);
  ASSERT_FALSE(opened.has_value());
  EXPECT_THAT(opened.error().what, HasSubstr("the most that a kiosk shows is 1024"));
}

TEST(ContentReader, SaysThatAFlippedByteIsDamage) {
  const Error error = refusal_with_flipped_byte(20000, std::byte{1});

  EXPECT_EQ(error.code, Errc::Damaged);
  EXPECT_THAT(error.what, HasSubstr("is damaged (its checksum does not match)"));
  EXPECT_THAT(error.what, HasSubstr("recompile the content"));
}

TEST(ContentReader, NoticesAFileCutShortAnywhere) {
  const std::vector<std::byte> whole = write::encode_museum(small_museum());
  for (const std::size_t size : {std::size_t{0}, std::size_t{10}, std::size_t{99}, std::size_t{100},
                                 whole.size() / 2, whole.size() - 1}) {
    const Error error = refusal({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)});

    EXPECT_EQ(error.code, Errc::Damaged) << size;
    EXPECT_THAT(error.what, HasSubstr("is cut short")) << size;
  }
}

TEST(ContentReader, NoticesBytesAfterTheEnd) {
  std::vector<std::byte> bytes = write::encode_museum(small_museum());
  bytes.resize(bytes.size() + 8192);

  EXPECT_EQ(refusal(bytes).code, Errc::Damaged);
}

TEST(ContentReader, NamesTheVersionThatItCannotRead) {
  std::vector<std::byte> bytes = write::encode_museum(small_museum());
  bytes[63] = std::byte{schema::version + 1};  // the last byte of user_version

  const Error error = refusal(bytes);

  EXPECT_EQ(error.code, Errc::WrongVersion);
  EXPECT_THAT(error.what, HasSubstr(fmt::format("has schema version {}", schema::version + 1)));
  EXPECT_THAT(error.what, HasSubstr("recompile the content"));
}

TEST(ContentReader, RefusesFilesThatAreNoDatabasesOfOurs) {
  const std::string text(5000, 'x');
  const auto* bytes = reinterpret_cast<const std::byte*>(text.data());
  std::vector<std::byte> foreign = write::encode_museum(small_museum());
  foreign[68] = std::byte{0};  // application_id

  EXPECT_THAT(refusal({bytes, bytes + text.size()}).what, HasSubstr("is not a docent database"));
  EXPECT_THAT(refusal(foreign).what, HasSubstr("is a database of another program"));
}

TEST(ContentReader, SaysThatThereIsNoFile) {
  const auto museum = load_museum("no/such/museum.db");

  ASSERT_FALSE(museum.has_value());
  EXPECT_EQ(museum.error().code, Errc::NotFound);
  EXPECT_THAT(museum.error().what, HasSubstr("no/such/museum.db: there is no such database"));
}

TEST(ContentReader, SaysThatAFolderIsNoDatabase) {
  const auto museum = load_museum(std::filesystem::temp_directory_path());

  ASSERT_FALSE(museum.has_value());
  EXPECT_EQ(museum.error().code, Errc::InvalidInput);
}

/// Spoils one thing in a museum, so that its database is sound and its content is not.
struct Spoiler {
  const char* what;
  void (*spoil)(Museum&);
};

/// A well-formed database with a valid checksum may still have been made by somebody hostile.
TEST(ContentReader, RefusesIndicesThatLeadNowhereAndSoDoesTheWriter) {
  const TemporaryFolder folder;
  const Spoiler spoilers[] = {
      {"walls", [](Museum& m) { m.floors[0].plan.next[2] = 99; }},
      {"walls", [](Museum& m) { m.floors[0].plan.ring[0].count = 0xffffffff; }},
      {"walls", [](Museum& m) { m.floors[0].plan.vertex[1].x = NAN; }},
      {"Voronoi", [](Museum& m) { m.floors[0].diagram.edge[0].to = 7; }},
      {"Voronoi", [](Museum& m) { m.floors[0].diagram.region_first.back() = 1; }},
      {"Voronoi", [](Museum& m) { m.floors[0].diagram.site[1].index = 4; }},
      {"roadmap", [](Museum& m) { m.floors[0].roadmap.edges[0].voronoi_edge = 1; }},
      {"roadmap", [](Museum& m) { m.floors[0].roadmap.clearance.pop_back(); }},
      {"tangent", [](Museum& m) { m.floors[0].tangent_graphs[1].tangent[0].arrive_side = 2; }},
      {"tangent", [](Museum& m) { m.floors[0].tangent_graphs[1].tangent[0].onward = 0; }},
      {"tangent", [](Museum& m) { m.floors[0].tangent_graphs.clear(); }},
      {"sight", [](Museum& m) { m.floors[0].sight.cell_corner[0] = 1; }},
      {"sight", [](Museum& m) { m.floors[0].sight.columns = 3; }},
      {"sight", [](Museum& m) { m.floors[0].sight.cell_size = 0; }},
      {"labels", [](Museum& m) { m.floors[0].hub_labels[1].leaving.hub[0].hub = 1; }},
      {"labels", [](Museum& m) { m.floors[0].hub_labels[1].leaving.parent[0] = 0; }},
      {"labels", [](Museum& m) { m.floors[0].hub_labels[1].arriving.link[0] = 2; }},
      {"labels", [](Museum& m) { m.floors[0].hub_labels[1].link_part[0] = 1; }},
      {"labels", [](Museum& m) { m.floors[0].hub_labels.pop_back(); }},
      {"scenery", [](Museum& m) { m.scenery[0].indices[2] = 3; }},
      {"scenery", [](Museum& m) { m.scenery[0].parts[0].index_count = 6; }},
      {"scenery", [](Museum& m) { m.scenery[0].parts[0].surface = Surface::Count; }},
      {"scenery", [](Museum& m) { m.scenery[0].lightmap_height = 0x80000001; }},
      {"scenery", [](Museum& m) { m.scenery.clear(); }},
      {"room", [](Museum& m) { m.rooms[0].floor = 2; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].image = 2; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].room = 1; }},
      {"further pictures", [](Museum& m) { m.pictures[0].image = 2; }},
      {"further pictures", [](Museum& m) { m.pictures[0].exhibit = 1; }},
      {"further pictures", [](Museum& m) { m.pictures.resize(FurtherPicture::most); }},
      {"further pictures",
       [](Museum& m) {
         m.exhibits.push_back(m.exhibits.front());
         m.pictures.insert(m.pictures.begin(), {.exhibit = 1});
       }},
      {"captions", [](Museum& m) { m.cues[2].picture = 1; }},
      {"captions", [](Museum& m) { m.cues[2].language = 2; }},
      {"captions", [](Museum& m) { m.cues[0].begin = 2000; }},
      {"captions", [](Museum& m) { m.cues[0].end = 2001; }},
      {"captions", [](Museum& m) { m.cues[1].end = Cue::latest + 1; }},
      {"captions", [](Museum& m) { m.cues[1].text.clear(); }},
      {"captions", [](Museum& m) { m.cues[1].text.assign(Cue::most_letters + 1, 'a'); }},
      {"captions", [](Museum& m) { std::swap(m.cues[0], m.cues[2]); }},
      {"captions",
       [](Museum& m) {
         m.cues.clear();
         for (std::uint32_t i = 0; i <= Cue::most; ++i)
           m.cues.push_back({.begin = i, .end = i + 1, .text = "a"});
       }},
      {"its sounds", [](Museum& m) { m.sounds[0].exhibit = 1; }},
      {"its sounds", [](Museum& m) { m.sounds.resize(ExhibitSound::most + 1); }},
      {"its sounds", [](Museum& m) { m.sounds.push_back(m.sounds.front()); }},
      {"its sounds", [](Museum& m) { m.speech.erase(m.speech.begin() + 1); }},
      {"speech", [](Museum& m) { m.speech[1].samples = 1 + 300 * SpeechSound::rate; }},
      {"captions of its sounds", [](Museum& m) { m.sound_cues[2].sound = 1; }},
      {"captions of its sounds", [](Museum& m) { m.sound_cues[2].language = 2; }},
      {"captions of its sounds", [](Museum& m) { m.sound_cues[0].end = 1001; }},
      {"captions of its sounds", [](Museum& m) { m.sound_cues[1].end = SoundCue::latest + 1; }},
      {"captions of its sounds", [](Museum& m) { m.sound_cues[1].text.clear(); }},
      {"captions of its sounds",
       [](Museum& m) {
         m.sound_cues.clear();
         for (std::uint32_t i = 0; i <= SoundCue::most; ++i)
           m.sound_cues.push_back({.begin = i, .end = i + 1, .text = "a"});
       }},
      {"exhibit", [](Museum& m) { m.exhibits[0].viewing_point.heading = INFINITY; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].more["en"] = std::string(longest_more + 1, 'a'); }},
      {"exhibit",
       [](Museum& m) { m.exhibits[0].more["en"] = std::string(4 * longest_more + 1, '\x80'); }},
      {"exhibit", [](Museum& m) { m.exhibits[0].place = ExhibitPlace::OnWall; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches.push_back(m.exhibits[0].touches[0]); }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].beside = Side{2}; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].hand = Side{2}; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].body.position.x = 7; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].body.heading = NAN; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].palm.y = 3.1F; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].palm.z = NAN; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].ready.x = INFINITY; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].fingers = {}; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].thumb = {NAN, 0, 0}; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].normal *= 2.0F; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].lean = 0.31F; }},
      {"exhibit", [](Museum& m) { m.exhibits[0].touches[0].lean = -0.01F; }},
      {"connection 'lift'", [](Museum& m) { m.connections[0].stops[1].floor = 2; }},
      {"connection 'lift'", [](Museum& m) { m.connections[0].stops[1].floor = 0; }},
      {"connection 'lift'", [](Museum& m) { m.connections[0].stops.pop_back(); }},
      {"connection 'lift'", [](Museum& m) { std::ranges::reverse(m.connections[0].stops); }},
      {"connection 'lift'", [](Museum& m) { m.connections[0].kind = ConnectionKind{4}; }},
      {"connection 'lift'", [](Museum& m) { m.connections[0].direction = ConnectionDirection{3}; }},
      {"connection 'lift'", [](Museum& m) { m.connections[0].wait_seconds = INFINITY; }},
      {"connection 'lift'", [](Museum& m) { m.connections[0].metres_per_floor = -1; }},
      {"kiosk", [](Museum& m) { m.kiosk_floor = 2; }},
      {"kiosk 'cafe'", [](Museum& m) { m.kiosks[1].floor = 2; }},
      {"kiosk 'foyer'", [](Museum& m) { m.kiosks[0].placement.position.x = INFINITY; }},
      {"radius", [](Museum& m) { m.body_radius = 0; }},
      {"strolling visitors", [](Museum& m) { m.ambient.count = 100000; }},
      {"strolling visitors", [](Museum& m) { m.ambient.entrances[1].y = NAN; }},
      {"strolling visitors", [](Museum& m) { m.ambient.look_least = 0; }},
      {"strolling visitors", [](Museum& m) { m.ambient.look_most = 3; }},
      {"strolling visitors", [](Museum& m) { m.ambient.look_most = INFINITY; }},
      {"language", [](Museum& m) { m.languages.clear(); }},
      {"speech", [](Museum& m) { m.speech[1].language = 2; }},
      {"speech", [](Museum& m) { m.speech[1].language = 0; }},
      {"speech", [](Museum& m) { m.speech[0].samples = 1609; }},
      {"speech", [](Museum& m) { m.speech[0].samples = 0; }},
      {"speech", [](Museum& m) { m.speech[0].packets.pop_back(); }},
      {"speech", [](Museum& m) { m.speech[0].packets[1] = std::byte{1}; }},
      {"speech", [](Museum& m) { m.speech[0].packets[6] = std::byte{0x4c}; }},
      {"motion", [](Museum& m) { m.motion.skeleton.joint[1].parent = JointIndex{1}; }},
      {"motion", [](Museum& m) { m.motion.skeleton.part[3] = JointIndex{2}; }},
      {"motion", [](Museum& m) { m.motion.clips[0].rotation[1].x = NAN; }},
      {"motion",
       [](Museum& m) {
         m.motion.clips[0].joint_count = 1;
         m.motion.clips[0].rotation.resize(2);
       }},
      {"motion", [](Museum& m) { m.motion.clips[0].frame_rate = -1; }},
      {"motion", [](Museum& m) { m.motion.transitions[0].to.clip = 1; }},
      {"motion", [](Museum& m) { m.motion.transitions[0].radius = 1; }},
      {"classes of motion", [](Museum& m) { m.motion.classes.pop_back(); }},
      {"classes of motion", [](Museum& m) { m.motion.classes[0].name = "swim"; }},
      {"classes of motion", [](Museum& m) { m.motion.classes[1].name = "walk"; }},
      {"classes of motion", [](Museum& m) { m.motion.classes[0].coefficient[0] = 1; }},
      {"classes of motion", [](Museum& m) { m.motion.classes[1].coefficient[0] = 2; }},
      {"classes of motion", [](Museum& m) { m.motion.classes[0].transition = {1'000'000}; }},
      {"classes of motion",
       [](Museum& m) {
         m.motion.classes[0].coefficient[1] = m.motion.classes[1].coefficient[0] = NAN;
       }},
      {"own look", [](Museum& m) { m.livery.accent = 0x1000000; }},
      {"own look", [](Museum& m) { m.livery.logo = 2; }},
      {"own look", [](Museum& m) { m.livery.logo_at_night = 0; }},
      {"own look", [](Museum& m) { m.images[1].height = 0; }},
      {"own look", [](Museum& m) { m.livery.titles.languages = {1, 0}; }},
      {"own look", [](Museum& m) { m.livery.titles.languages = {2}; }},
      {"own look", [](Museum& m) { m.livery.titles.family = "A, B"; }},
      {"own look", [](Museum& m) { m.livery.text.languages = {0}; }},
      {"own look", [](Museum& m) { m.fonts[0].bytes.clear(); }},
      {"own look", [](Museum& m) { m.fonts.resize(Typeface::most_files + 1, m.fonts[0]); }},
      {"avatar", [](Museum& m) { m.avatar.vertices[0].joint[3] = 4; }},
      {"avatar", [](Museum& m) { m.avatar.indices[0] = 1; }},
      {"avatar", [](Museum& m) { m.avatar.figure_end.back() = 6; }},
      {"avatar", [](Museum& m) { m.avatar.inverse_bind.pop_back(); }},
      {"avatar", [](Museum& m) { m.avatar.colour.resize(m.avatar.vertices.size() + 1); }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[0].figure = 1; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[1].joint[3] = 2; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[0].above = 0; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[1].left = 2; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[1].keeps_out = 2; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[1].stiffness = NAN; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[1].kind = ClothKind::Bone; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[0].kind = ClothKind::Count; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[0].root.x = NAN; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[0].gravity.y = 2 * most_cloth_gravity; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.collider[0].from_radius = 2 * most_cloth_radius; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node[1].damping = 2 * most_cloth_damping; }},
      {"avatar", [](Museum& m) { --m.avatar.cloth.node[1].weight[0]; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.collider[0].joint = 2; }},
      {"avatar", [](Museum& m) { m.avatar.cloth.collider.resize(most_cloth_colliders + 1); }},
      {"avatar", [](Museum& m) { m.avatar.cloth.node.resize(most_joints - 1); }},
      {"avatar",
       [](Museum& m) {
         m.avatar.colour.resize(1);
         m.avatar.inverse_bind.push_back(Mat4(1));
       }},
      {"avatar",
       [](Museum& m) {
         Skeleton& body = m.motion.skeleton;
         for (MotionClip& clip : m.motion.clips) clip.rotation.clear();
         for (; body.joint.size() <= most_joints; body.has_rotation.push_back(false)) {
           body.joint.push_back({"finger", JointIndex{0}, {}});
           m.avatar.inverse_bind.resize(body.joint.size() + 1, Mat4(1));
         }
         for (MotionClip& clip : m.motion.clips) {
           clip.joint_count = static_cast<std::uint32_t>(body.joint.size());
           clip.rotation.resize(clip.joint_count * clip.root.size(), Quat(1, 0, 0, 0));
         }
       }},
  };
  for (const Spoiler& spoiler : spoilers) {
    Museum museum = small_museum();
    spoiler.spoil(museum);

    const Error error = refusal(write::encode_museum(museum));

    EXPECT_EQ(error.code, Errc::Damaged) << spoiler.what;
    EXPECT_THAT(error.what, HasSubstr(spoiler.what));
    EXPECT_THROW(write::write_museum(museum, folder.path() / "museum.db"), content::ContentError)
        << spoiler.what;
  }
}

/// Reads a museum out of a database in which `sql` has changed something.
Result<Museum> read_after(const char* sql) {
  const TemporaryFolder folder;
  write::write_museum(small_museum(), folder.path() / "museum.db");
  sqlite3* raw = nullptr;
  sqlite3_open((folder.path() / "museum.db").c_str(), &raw);
  const Database database{.bytes = {}, .handle = DatabaseHandle(raw)};
  EXPECT_EQ(sqlite3_exec(raw, sql, nullptr, nullptr, nullptr), SQLITE_OK);
  return read_museum(database, "museum.db");
}

TEST(ContentReader, SaysThatMotionIsDamagedWhichCannotBeDecoded) {
  EXPECT_TRUE(read_after("UPDATE motion_clip SET motion = motion").has_value());
  for (const char* sql : {"UPDATE motion_clip SET motion = x''",
                          "UPDATE motion_clip SET motion = substr(motion, 1, length(motion) - 1)",
                          "UPDATE motion_clip SET motion = CAST(motion || x'00' AS BLOB)",
                          "UPDATE motion_clip SET motion = x'0DFFFFFFFFFFFFFFFF00'"}) {
    const auto museum = read_after(sql);

    ASSERT_FALSE(museum.has_value()) << sql;
    EXPECT_EQ(museum.error().code, Errc::Damaged);
    EXPECT_THAT(museum.error().what, HasSubstr("table motion_clip does not hold what it should"));
  }
}

TEST(ContentReader, SaysThatClassesAreDamagedWhichCannotBeDecoded) {
  for (const char* sql : {"UPDATE motion_class SET coefficient = x'000000'",
                          "UPDATE motion_class SET coefficient = 'none'",
                          "UPDATE motion_class SET transition = x'000000'",
                          "UPDATE motion_class SET name = x'00' WHERE id = 1"}) {
    const auto museum = read_after(sql);

    ASSERT_FALSE(museum.has_value()) << sql;
    EXPECT_EQ(museum.error().code, Errc::Damaged);
    EXPECT_THAT(museum.error().what, HasSubstr("motion_class"));
  }
}

TEST(ContentReader, ReadsWhatIsSaidWithoutTheRest) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "museum.db";
  write::write_museum(small_museum(), file);

  const auto speech = read_speech(*open_database(file), file);

  ASSERT_TRUE(speech.has_value()) << speech.error().what;
  ASSERT_EQ(speech->size(), 3U);
  EXPECT_EQ(speech->back().text, "Jade disc");
  EXPECT_EQ(speech->back().packets, small_museum().speech.back().packets);
}

TEST(ContentWriter, GivesTheSameBytesForTheSameMuseum) {
  EXPECT_EQ(write::encode_museum(small_museum()), write::encode_museum(small_museum()));
}

TEST(ContentWriter, LeavesTheOldFileWhereTheNewOneCannotBeWritten) {
  const TemporaryFolder folder;
  const auto occupied = folder.path() / "museum.db";
  std::filesystem::create_directories(occupied / "not-empty");

  try {
    write::write_museum(small_museum(), occupied);
    FAIL() << "wrote a file over a folder";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(exit_code(error.kind), 3);
    EXPECT_THAT(error.what(), HasSubstr("cannot be written"));
  }
  EXPECT_TRUE(std::filesystem::is_directory(occupied));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1)
      << "left a temporary file behind";
}

TEST(ContentWriter, SaysThatTheFolderIsMissing) {
  try {
    write::write_museum(small_museum(), "no/such/folder/museum.db");
    FAIL();
  } catch (const content::ContentError& error) {
    EXPECT_EQ(exit_code(error.kind), 3);
    EXPECT_THAT(error.what(), HasSubstr("the folder 'no/such/folder' does not exist"));
  }
}

}  // namespace
}  // namespace docent::sqlite::content_reader_test
