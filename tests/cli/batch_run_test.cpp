// SPDX-License-Identifier: MIT
// Long runs of `hodograph batch`: several jobs, kills and what goes on after
// them, faults, closed pipes and full disks. The results are those of one
// unbroken run, byte for byte.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/random.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

Json climb(Random& rng, int id) {
  return {{"request", "climb"},
          {"id", id},
          {"begin", {{"position", {0, 0, 0}}, {"heading", rng.uniform(-0.5, 0.5)}}},
          {"end",
           {{"position", {rng.uniform(20, 40), rng.uniform(-9, 9), rng.uniform(3, 12)}},
            {"heading", rng.uniform(-0.5, 0.5)}}},
          {"climb_angle", 0.2}};
}

/// Climbs, some of them impossible, and lines of other kinds between them.
std::string climbs(int count, bool with_faults = true) {
  Random rng("BatchRun.climbs");
  std::string lines;
  for (int i = 0; i < count; ++i) {
    Json request = climb(rng, i);
    if (!with_faults) {
      request["climb_angle"] = 0.05;
      request["end"]["position"] = {30, 4, 2};
      request["begin"]["heading"] = 0.1 + rng.uniform(-0.05, 0.05);
      request["end"]["heading"] = 0.1;
    }
    lines += request.dump() + "\n";
    if (!with_faults) continue;
    if (i % 17 == 3) lines += "no json\n";
    if (i % 23 == 5) lines += " \n\n";
    if (i % 29 == 7) {
      lines += R"({"request": "rational_hermite", "begin": 1})"
               "\n"
               R"({"request": "fit", "formula": "cos(t), sin(t), t", "to": 3, "tolerance": 1e-4})"
               "\n";
    }
  }
  return lines;
}

std::string unbroken(const Program& program, const std::string& file) {
  const Outcome outcome = program.run({"batch", file, "--jobs", "1"});
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  return outcome.out;
}

std::vector<std::string> files_of(const Program& program) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(program.path(""))) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(".std")) names.push_back(name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// Starts a run on a pipe that stays open, waits until `answered` lines are in
/// out.jsonl.partial, and does `then` with the process $p.
std::string broken_off(const std::string& input, int answered, const std::string& then,
                       const std::string& options = "") {
  return "mkfifo in && exec 9<>in && { env --default-signal=INT hodograph batch in -o out.jsonl " +
         options + " & } && p=$! && cat " + input +
         " >&9 && for i in $(seq 1000); do n=$(cat out.jsonl.partial "
         "2>/dev/null | wc -l); "
         "[ \"$n\" -ge " +
         std::to_string(answered) + " ] && break; sleep 0.01; done; rm in; " + then;
}

TEST(BatchRun, TheResultsDoNotDependOnTheNumberOfJobs) {
  const Program program;
  write_text(program.path("in.jsonl"), climbs(150));
  const std::string one = unbroken(program, "in.jsonl");
  EXPECT_GT(line_count(one), 150u);
  EXPECT_NE(one.find("\"ok\": false"), std::string::npos);
  for (const char* const jobs : {"2", "4", "16"}) {
    const Outcome several = program.run({"batch", "in.jsonl", "--jobs", jobs});
    EXPECT_EQ(several.code, 0);
    EXPECT_TRUE(several.out == one) << jobs;
    EXPECT_EQ(program.run({"batch", "in.jsonl", "-o", "out.jsonl", "-j", jobs}).code, 0);
    EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == one) << jobs;
  }
  EXPECT_EQ(files_of(program), (std::vector<std::string>{"in.jsonl", "out.jsonl"}));
}

TEST(BatchRun, ALineIsAnsweredBeforeTheNextArrives) {
  const Program program;
  Random rng("BatchRun.ALineIsAnsweredBeforeTheNextArrives");
  write_text(program.path("one"), climb(rng, 1).dump() + "\n");
  const Outcome outcome = program.shell(
      "mkfifo in out && { hodograph batch in > out & } && exec "
      "9<>out && exec 8>in && "
      "for i in 1 2 3; do cat one >&8; IFS= read -r answer <&9; "
      "printf '%s\\n' \"$answer\"; done; "
      "exec 8>&-; wait");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(line_count(outcome.out), 3u);
}

TEST(BatchRun, AKilledRunGoesOn) {
  for (const char* const jobs : {"1", "3"}) {
    const Program program;
    const std::string lines = climbs(120);
    write_text(program.path("all.jsonl"), lines);
    write_text(program.path("half.jsonl"), lines.substr(0, lines.size() / 2));  // ends in a line
    const std::string whole = unbroken(program, "all.jsonl");
    write_text(program.path("out.jsonl"), "what was there before\n");
    const Outcome killed = program.shell(
        broken_off("half.jsonl", 40, "kill -9 $p; wait $p", std::string("-j ") + jobs));
    EXPECT_EQ(killed.code, 128 + 9) << killed.err;
    EXPECT_EQ(text_of_file(program.path("out.jsonl")), "what was there before\n");
    const std::string partial = text_of_file(program.path("out.jsonl.partial"));
    EXPECT_GE(line_count(partial), 40u);
    EXPECT_LT(line_count(partial), line_count(whole));
    EXPECT_TRUE(whole.starts_with(partial));

    const Outcome again = program.run({"batch", "all.jsonl", "-o", "out.jsonl"});
    expect_refused(again, "--resume");
    EXPECT_EQ(text_of_file(program.path("out.jsonl.partial")), partial);
    const Outcome resumed =
        program.run({"batch", "all.jsonl", "-o", "out.jsonl", "--resume", "-j", jobs});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_EQ(resumed.err, "");
    EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == whole);
    EXPECT_EQ(files_of(program),
              (std::vector<std::string>{"all.jsonl", "half.jsonl", "out.jsonl"}));
  }
}

TEST(BatchRun, WhatIsTornIsDropped) {
  const Program program;
  const std::string lines = climbs(30);
  write_text(program.path("all.jsonl"), lines);
  const std::string whole = unbroken(program, "all.jsonl");
  const Outcome killed = program.shell(broken_off("all.jsonl", 20, "kill -9 $p; wait $p"));
  EXPECT_EQ(killed.code, 128 + 9) << killed.err;
  const std::string partial = text_of_file(program.path("out.jsonl.partial"));
  const std::string records = text_of_file(program.path("out.jsonl.partial.lines"));
  ASSERT_GE(line_count(partial), 20u);

  Random rng("BatchRun.WhatIsTornIsDropped");
  const auto cut = [&](const std::string& text) {
    return text.substr(0,
                       static_cast<std::size_t>(rng.integer(1, static_cast<int>(text.size()) - 1)));
  };
  const std::size_t heading = records.find('\n') + 1;
  for (int i = 0; i < 12; ++i) {
    std::string torn = i % 3 == 0 ? partial : cut(partial);
    std::string torn_records =
        i % 3 == 1 ? records : records.substr(0, heading) + cut(records.substr(heading));
    if (i % 4 == 1) torn += std::string(40, '\0');  // a disk that lost power
    if (i % 4 == 2) torn[torn.size() / 2] ^= 1;
    if (i % 4 == 3) torn_records[heading + (torn_records.size() - heading) / 2] = '?';
    write_text(program.path("out.jsonl.partial"), torn);
    write_text(program.path("out.jsonl.partial.lines"), torn_records);
    const Outcome resumed = program.run({"batch", "all.jsonl", "-o", "out.jsonl", "--resume"});
    EXPECT_EQ(resumed.code, 0) << resumed.err;
    EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == whole) << i;
    EXPECT_EQ(files_of(program), (std::vector<std::string>{"all.jsonl", "out.jsonl"}));
  }
}

TEST(BatchRun, OtherRequestsAreNotGoneOnWith) {
  const Program program;
  const std::string lines = climbs(30);
  write_text(program.path("all.jsonl"), lines);
  program.shell(broken_off("all.jsonl", 30, "kill -9 $p; wait $p"));
  const std::string partial = text_of_file(program.path("out.jsonl.partial"));
  const auto resumed = [&](const std::string& requests) {
    write_text(program.path("other.jsonl"), requests);
    return program.run({"batch", "other.jsonl", "-o", "out.jsonl", "--resume"});
  };
  std::string changed = lines;
  changed[changed.find("heading") + 12] ^= 1;
  expect_refused(resumed(changed), "line 1 of the requests is not what was answered");
  expect_refused(resumed(lines.substr(lines.find('\n') + 1)), "line 1 of the requests");
  expect_refused(resumed(lines.substr(0, lines.find('\n') + 1)), "end after 1 line");
  expect_refused(resumed(""), "end after 0 lines");
  EXPECT_EQ(text_of_file(program.path("out.jsonl.partial")), partial);

  // Requests that were added at the end, and blank lines anywhere, are no
  // change.
  const std::string more = "\n" + lines + "{\"request\": \"orbit\"}\n";
  EXPECT_EQ(resumed(more).code, 0);
  EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == unbroken(program, "other.jsonl"));
}

TEST(BatchRun, FilesOfOthersAreLeftAlone) {
  const Program program;
  write_text(program.path("in.jsonl"), climbs(3));
  write_text(program.path("out.jsonl.partial"), "my notes\n");
  const std::vector<std::string> resume = {"batch", "in.jsonl", "-o", "out.jsonl", "--resume"};
  expect_refused(program.run({"batch", "in.jsonl", "-o", "out.jsonl"}), "out.jsonl.partial");
  expect_refused(program.run(resume), "out.jsonl.partial.lines");
  write_text(program.path("out.jsonl.partial.lines"), "hodograph batch 1, version 0.0.0\n");
  expect_refused(program.run(resume), "this version");
  EXPECT_EQ(text_of_file(program.path("out.jsonl.partial")), "my notes\n");

  expect_refused(program.run({"batch", "in.jsonl", "--resume"}), "--resume");
  expect_refused(program.run({"batch", "in.jsonl", "-o", "-", "--resume"}), "-o FILE");
  expect_refused(program.run({"batch", "in.jsonl", "-o", "/dev/null", "--resume"}), "/dev/null");
  expect_refused(program.run({"batch", "in.jsonl", "-o", "."}), "directory");
  expect_refused(program.run({"batch", "in.jsonl", "-o", "no/where"}), "No such file");
  expect_refused(program.run({"batch", "in.jsonl", "--jobs", "0"}), "--jobs");
  expect_refused(program.run({"batch", "in.jsonl", "--on-fault", "cry"}), "--on-fault");
  EXPECT_EQ(program.run({"batch", "in.jsonl", "-o", "/dev/null"}).code, 0);
}

TEST(BatchRun, ResumingWithNothingThereIsARun) {
  const Program program;
  write_text(program.path("in.jsonl"), climbs(5));
  EXPECT_EQ(program.run({"batch", "in.jsonl", "-o", "out.jsonl", "--resume"}).code, 0);
  EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == unbroken(program, "in.jsonl"));
  write_text(program.path("out.jsonl.partial.lines"), "left over\n");
  EXPECT_EQ(program.run({"batch", "in.jsonl", "-o", "out.jsonl", "--resume"}).code, 0);
  EXPECT_EQ(files_of(program), (std::vector<std::string>{"in.jsonl", "out.jsonl"}));
}

TEST(BatchRun, TwoProcessesDoNotWriteTheSameFile) {
  const Program program;
  write_text(program.path("all.jsonl"), climbs(5));
  const Outcome outcome = program.shell(broken_off("all.jsonl", 5,
                                                   "hodograph batch all.jsonl -o out.jsonl "
                                                   "--resume; echo $?; kill -9 $p; wait $p"));
  EXPECT_EQ(outcome.out, "2\n");
  EXPECT_NE(outcome.err.find("another process"), std::string::npos) << outcome.err;
}

TEST(BatchRun, FaultsAreSkippedAndCounted) {
  const Program program;
  write_text(program.path("in.jsonl"), climbs(60));
  std::string answered;
  std::size_t faults = 0;
  for (const std::string& line : lines_of(unbroken(program, "in.jsonl"))) {
    const bool good = line.find("\"ok\": true") != std::string::npos;
    if (good) answered += line + "\n";
    faults += good ? 0 : 1;
  }
  ASSERT_GT(faults, 5u);
  const Outcome skipped = program.run({"batch", "in.jsonl", "--on-fault", "skip", "-j", "2"});
  EXPECT_EQ(skipped.code, 0);
  EXPECT_TRUE(skipped.out == answered);
  const auto said = lines_of(skipped.err);
  ASSERT_EQ(said.size(), faults + 1);
  EXPECT_TRUE(said.front().starts_with("hodograph: skipped line ")) << said.front();
  EXPECT_NE(said.back().find(std::to_string(faults) + " skipped faults"), std::string::npos);

  // The same from a run that was killed, and only with the same way of treating
  // faults.
  const Outcome killed =
      program.shell(broken_off("in.jsonl", 10, "kill -9 $p; wait $p", "--on-fault skip"));
  EXPECT_EQ(killed.code, 128 + 9);
  expect_refused(program.run({"batch", "in.jsonl", "-o", "out.jsonl", "--resume"}),
                 "go on with --on-fault skip");
  const Outcome resumed = program.run(
      {"batch", "in.jsonl", "-o", "out.jsonl", "--resume", "--on-fault", "skip", "--progress"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == answered);
  EXPECT_NE(resumed.err.find("going on after "), std::string::npos);
  EXPECT_EQ(lines_of(resumed.err).back().substr(0, said.back().rfind(',')),
            said.back().substr(0, said.back().rfind(',')));
}

TEST(BatchRun, AFaultStopsWhereAsked) {
  const Program program;
  const std::string good = climbs(20, false);
  std::string bad = good;
  const std::size_t middle = good.find('\n', good.size() / 2) + 1;
  bad.insert(middle, "{\"request\": \"teleport\"}\n");
  write_text(program.path("good.jsonl"), good);
  write_text(program.path("bad.jsonl"), bad);
  const std::string whole = unbroken(program, "good.jsonl");
  ASSERT_EQ(whole.find("\"ok\": false"), std::string::npos);
  for (const char* const jobs : {"1", "4"}) {
    const Outcome stopped =
        program.run({"batch", "bad.jsonl", "--on-fault", "stop", "--jobs", jobs});
    EXPECT_EQ(stopped.code, 2);
    EXPECT_TRUE(stopped.err.starts_with("hodograph: line ")) << stopped.err;
    EXPECT_NE(stopped.err.find("teleport"), std::string::npos);
    EXPECT_TRUE(whole.starts_with(stopped.out));
    EXPECT_EQ(line_count(stopped.out), line_count(good.substr(0, middle)));

    EXPECT_EQ(program.run({"batch", "bad.jsonl", "-o", "out.jsonl", "--on-fault", "stop"}).code, 2);
    // The bad line is mended, and the run goes on.
    EXPECT_EQ(program.run({"batch", "good.jsonl", "-o", "out.jsonl", "--resume"}).code, 0);
    EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == whole);
  }
  Json impossible = Json::parse(lines_of(good).front());
  impossible["climb_angle"] = 1.5;
  const Outcome none =
      program.run({"batch", "--on-fault", "stop"}, impossible.dump() + "\n" + good);
  EXPECT_EQ(none.code, 3) << none.err;
  EXPECT_EQ(none.out, "");
}

TEST(BatchRun, AnInterruptLeavesARunToGoOnWith) {
  const Program program;
  const std::string lines = climbs(60);
  write_text(program.path("all.jsonl"), lines);
  write_text(program.path("half.jsonl"), lines.substr(0, lines.size() / 2));
  const Outcome interrupted =
      program.shell(broken_off("half.jsonl", 10, "kill -INT $p; wait $p", "--jobs 2"));
  EXPECT_EQ(interrupted.code, 1);
  EXPECT_TRUE(interrupted.err.starts_with("hodograph: interrupted after ")) << interrupted.err;
  EXPECT_NE(interrupted.err.find("--resume goes on"), std::string::npos) << interrupted.err;
  EXPECT_EQ(program.run({"batch", "all.jsonl", "-o", "out.jsonl", "--resume"}).code, 0);
  EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == unbroken(program, "all.jsonl"));
}

TEST(BatchRun, AFullDiskEndsTheRunAndLeavesWhatIsWhole) {
  const Program program;
  write_text(program.path("in.jsonl"), climbs(150));
  const std::string whole = unbroken(program, "in.jsonl");
  const Outcome full = program.shell(
      "trap '' XFSZ; ulimit -f 40; hodograph "
      "batch in.jsonl -o out.jsonl --jobs 2");
  EXPECT_EQ(full.code, 2);
  EXPECT_NE(full.err.find("cannot write 'out.jsonl': File too large"), std::string::npos)
      << full.err;
  const std::string partial = text_of_file(program.path("out.jsonl.partial"));
  EXPECT_GT(partial.size(), 10'000u);
  EXPECT_LT(partial.size(), whole.size());
  const Outcome resumed = program.run({"batch", "in.jsonl", "-o", "out.jsonl", "--resume"});
  EXPECT_EQ(resumed.code, 0) << resumed.err;
  EXPECT_TRUE(text_of_file(program.path("out.jsonl")) == whole);

  const Outcome device = program.shell("hodograph batch in.jsonl > /dev/full");
  EXPECT_EQ(device.code, 2);
  EXPECT_NE(device.err.find("No space left"), std::string::npos) << device.err;
  EXPECT_EQ(line_count(device.err), 1u);
  const Outcome closed = program.shell("hodograph batch in.jsonl >&-");
  EXPECT_EQ(closed.code, 2);
}

TEST(BatchRun, AClosedPipeEndsTheRun) {
  const Program program;
  write_text(program.path("one"), lines_of(climbs(1)).front());
  for (const char* const trap : {"", "trap '' PIPE; "}) {
    const Outcome outcome = program.shell(std::string(trap) +
                                          "yes \"$(cat one)\" 2>/dev/null | "
                                          "timeout 10 hodograph batch --jobs 4 2>/dev/null | "
                                          "head -n 3");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(line_count(outcome.out), 3u);
  }
}

TEST(BatchRun, ProgressIsSilentUnlessAskedFor) {
  const Program program;
  const Outcome quiet = program.run({"batch"}, climbs(3));
  EXPECT_EQ(quiet.err, "");
  const Outcome asked = program.run({"batch", "--progress"}, climbs(3));
  EXPECT_EQ(asked.out, quiet.out);
  EXPECT_EQ(line_count(asked.err), 1u);
  EXPECT_TRUE(
      asked.err.starts_with("hodograph: " + std::to_string(line_count(quiet.out)) + " lines, "))
      << asked.err;
}

/// What a terminal receives while a line is typed into it: `script` is the terminal.
std::string on_a_terminal(const Program& program, const std::string& line) {
  write_text(program.path("typed.sh"), line);
  const Outcome outcome = program.shell("script -qec 'sh typed.sh' /dev/null < /dev/null");
  EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
  return outcome.out;
}

constexpr std::string_view rewrite = "\r\x1b[K";  // back to the first column, and wipe the line

TEST(BatchRun, OnATerminalALineOfProgressIsRewrittenInPlaceAndWiped) {
  const Program program;
  write_text(program.path("in"), climbs(20, false));
  const std::string answers = unbroken(program, program.path("in"));
  // Requests come slowly: more than the time between two updates passes.
  const std::string shown = on_a_terminal(
      program, "{ cat in; sleep 0.5; cat in; sleep 0.3; } | hodograph batch -o out.jsonl");
  EXPECT_EQ(text_of_file(program.path("out.jsonl")), answers + answers);
  ASSERT_TRUE(shown.starts_with(std::string(rewrite) + "answered: ")) << shown;
  const std::size_t last = shown.rfind(rewrite);
  EXPECT_TRUE(
      shown.substr(last).starts_with(std::string(rewrite) + "hodograph: 40 lines, 0 faults, "))
      << shown;
  // Nothing but the last line stays.
  EXPECT_EQ(shown.find('\n'), shown.size() - 1) << shown;
  EXPECT_GT(last, 0u);
}

TEST(BatchRun, OnATerminalTheShareOfAFileAndTheTimeLeftAreShown) {
  const Program program;
  write_text(program.path("in.jsonl"), climbs(200, false));
  const std::string answers = unbroken(program, program.path("in.jsonl"));
  constexpr std::size_t pipe_holds = 65536;
  ASSERT_GT(answers.size(), 2 * pipe_holds);
  // The reader of the answers is slow, the terminal shows standard error alone.
  const std::string shown =
      on_a_terminal(program, "hodograph batch in.jsonl | { sleep 0.5; cat > out.jsonl; }");
  EXPECT_EQ(text_of_file(program.path("out.jsonl")), answers);
  EXPECT_NE(shown.find("/s, "), std::string::npos) << shown;
  EXPECT_NE(shown.find(" %, "), std::string::npos) << shown;
  EXPECT_NE(shown.find(" left"), std::string::npos) << shown;
}

TEST(BatchRun, OnATerminalSkippedLinesStay) {
  const Program program;
  write_text(program.path("in.jsonl"), climbs(3, false));
  const std::string shown =
      on_a_terminal(program,
                    "{ cat in.jsonl; sleep 0.4; echo no json; cat in.jsonl; } | "
                    "hodograph batch -o out.jsonl --on-fault skip");
  const std::size_t skipped = shown.find(std::string(rewrite) + "hodograph: skipped line 4: ");
  ASSERT_NE(skipped, std::string::npos) << shown;  // the progress line makes room for it
  EXPECT_EQ(std::count(shown.begin(), shown.end(), '\n'), 2) << shown;
}

TEST(BatchRun, NothingInNothingOut) {
  const Program program;
  for (const char* const text : {"", "\n", " \n\t\r\n"}) {
    const Outcome outcome = program.run({"batch", "-o", "out.jsonl", "--on-fault", "skip"}, text);
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(text_of_file(program.path("out.jsonl")), "");
    EXPECT_EQ(files_of(program), std::vector<std::string>{"out.jsonl"});
  }
}

}  // namespace
}  // namespace hodograph::test
