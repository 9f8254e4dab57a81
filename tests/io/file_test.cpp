// SPDX-License-Identifier: MIT
// Whole files in and out: faults name the file and the reason, a failed write leaves the old file.
#include "hodograph/io/file.hpp"

#include <gtest/gtest.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <utility>

#include "temporary_directory.hpp"

namespace hodograph {
namespace {

class File : public ::testing::Test {
 protected:
  TemporaryDirectory directory_;
  std::string path(const std::string& name) const { return directory_.path(name); }
  std::size_t entries() const {
    const std::filesystem::directory_iterator begin(directory_.path(""));
    return static_cast<std::size_t>(std::distance(begin, std::filesystem::directory_iterator{}));
  }
};

TEST_F(File, WhatIsWrittenIsRead) {
  const std::string bytes("a\0b\r\n\xff", 6);
  ASSERT_FALSE(write_file(path("f"), bytes));
  EXPECT_EQ(read_file(path("f")).value(), bytes);
  ASSERT_FALSE(write_file(path("f"), ""));
  EXPECT_EQ(read_file(path("f")).value(), "");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(File, LargeFilesGoThroughTheBuffer) {
  std::string bytes;
  for (int i = 0; i < 500000; ++i) bytes += std::to_string(i);
  auto file = OutputFile::create(path("f"));
  ASSERT_TRUE(file);
  file->write(std::string_view(bytes).substr(0, 17));
  file->write(std::string_view(bytes).substr(17));
  ASSERT_FALSE(file->commit());
  EXPECT_EQ(read_file(path("f")).value(), bytes);
}

TEST_F(File, ReadingFailsWithTheReason) {
  EXPECT_EQ(read_file(path("none")).fault().sentence,
            "cannot read '" + path("none") + "': No such file or directory");
  EXPECT_EQ(read_file(path("")).fault().sentence,
            "cannot read '" + path("") + "': it is a directory, not a file");
  EXPECT_EQ(read_file("").fault().sentence, "cannot read '': No such file or directory");
  ASSERT_FALSE(write_file(path("f"), "12345678"));
  const Fault fault = read_file(path("f"), 7).fault();
  EXPECT_EQ(fault.sentence,
            "cannot read '" + path("f") +
                "': it is larger than the limit of 7 bytes (the file has at least 8)");
  EXPECT_EQ(fault.code, FaultCode::malformed_document);
  EXPECT_EQ(read_file(path("f"), 8).value(), "12345678");
}

TEST_F(File, AnEndlessFileIsRefused) {
  const auto result = read_file("/dev/zero", 1000);
  ASSERT_FALSE(result);
  EXPECT_NE(result.fault().sentence.find("limit of 1000 bytes"), std::string::npos);
}

TEST_F(File, AHostileNameStaysOnOneLine) {
  const std::string sentence = read_file("no\nsuch\x1b[31m\xff").fault().sentence;
  EXPECT_EQ(sentence, "cannot read 'no\\x0asuch\\x1b[31m\\xff': No such file or directory");
}

TEST_F(File, WithoutCommitTheOldFileStaysWhole) {
  ASSERT_FALSE(write_file(path("f"), "old"));
  {
    auto file = OutputFile::create(path("f"));
    ASSERT_TRUE(file);
    file->write("new");
    OutputFile moved = std::move(*file);
    moved.write(" and more");
    EXPECT_EQ(read_file(path("f")).value(), "old");
    EXPECT_EQ(entries(), 2U);
  }
  EXPECT_EQ(read_file(path("f")).value(), "old");
  EXPECT_EQ(entries(), 1U);
}

TEST_F(File, WritingFailsWithTheReasonAndLeavesNothing) {
  auto fault = write_file(path("none/f"), "x");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->code, FaultCode::not_written);
  EXPECT_EQ(fault->sentence, "cannot write '" + path("none/f") + "': No such file or directory");
  fault = write_file(path(""), "x");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->sentence, "cannot write '" + path("") + "': Is a directory");
  fault = write_file("", "x");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->sentence, "cannot write '': No such file or directory");
  EXPECT_EQ(entries(), 0U);
}

TEST_F(File, AFullDiskIsReported) {
  ASSERT_EQ(::access("/dev/full", W_OK), 0) << "every Linux has /dev/full";
  const auto fault = write_file("/dev/full", "x");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->sentence, "cannot write '/dev/full': No space left on device");
}

// A limit on the size of files stands for a disk that fills up half-way; it holds for everybody.
TEST_F(File, ADiskThatFillsUpLeavesTheOldFile) {
  ASSERT_FALSE(write_file(path("f"), "old"));
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto fault = write_file(path("f"), std::string(5000000, 'x'));
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->sentence, "cannot write '" + path("f") + "': File too large");
  EXPECT_EQ(read_file(path("f")).value(), "old");
  EXPECT_EQ(entries(), 1U);
}

// The superuser may write everywhere, and therefore writes as nobody, whose the directory is.
TEST_F(File, ADirectoryThatMayNotBeWrittenLeavesTheOldFile) {
  constexpr uid_t nobody = 65534;
  const bool superuser = ::geteuid() == 0;
  ASSERT_FALSE(write_file(path("f"), "old"));
  if (superuser) {
    ASSERT_EQ(::chown(path("").c_str(), nobody, static_cast<gid_t>(-1)), 0);
  }
  ASSERT_EQ(::chmod(path("").c_str(), 0500), 0);
  if (superuser) {
    ASSERT_EQ(::seteuid(nobody), 0);
  }
  const auto fault = write_file(path("f"), "new");
  if (superuser) {
    ASSERT_EQ(::seteuid(0), 0);
    ::prctl(PR_SET_DUMPABLE, 1);  // which seteuid takes away, and the leak sanitizer needs
  }
  ::chmod(path("").c_str(), 0700);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->sentence, "cannot write '" + path("f") + "': Permission denied");
  EXPECT_EQ(read_file(path("f")).value(), "old");
}

TEST_F(File, ADirectoryThatVanishesLeavesNoHalfFile) {
  ASSERT_EQ(::mkdir(path("d").c_str(), 0700), 0);
  auto file = OutputFile::create(path("d/f"));
  ASSERT_TRUE(file);
  file->write("new");
  std::filesystem::remove_all(path("d"));
  const auto fault = file->commit();
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->sentence, "cannot write '" + path("d/f") + "': No such file or directory");
}

TEST_F(File, LinksAndPermissionsStay) {
  ASSERT_FALSE(write_file(path("f"), "old"));
  ASSERT_EQ(::chmod(path("f").c_str(), 0640), 0);
  ASSERT_EQ(::symlink("f", path("link").c_str()), 0);
  ASSERT_FALSE(write_file(path("link"), "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(read_file(path("f")).value(), "new");
  struct stat status {};
  ASSERT_EQ(::stat(path("f").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
}

TEST_F(File, ADeviceIsWrittenToAndNotReplaced) {
  ASSERT_FALSE(write_file("/dev/null", "x"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace hodograph
