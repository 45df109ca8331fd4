// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/temperatures/temperature_log.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

namespace axiometry::formats {
namespace {

using ::testing::Contains;
using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

TemperatureLog log_of(std::string_view text, const SensorRoles& roles = {}) {
  auto log = read_temperature_log(text, roles);
  EXPECT_TRUE(log) << (log ? "" : log.error().to_string());
  return log ? *std::move(log) : TemperatureLog{};
}

std::string refusal(std::string_view text, const SensorRoles& roles = {}) {
  const auto log = read_temperature_log(text, roles);
  return log ? "read" : log.error().to_string();
}

TEST(TemperatureLogs, HaveATimeAndSensorsWithRolesByTheirNames) {
  const auto log = log_of(
      "time,Air [°C],Bed [°C],Laser head [°C]\n"
      "2026-03-02T08:00:00,20.1,20.5,21\n"
      "2026-03-02T08:10:00,20.2,20.4,22.5\n");
  ASSERT_EQ(log.sensors.size(), 3u);
  EXPECT_EQ(log.sensors[0].location, "Air");
  EXPECT_EQ(log.sensors[0].role, "air");
  EXPECT_EQ(log.sensors[1].role, "machine");
  EXPECT_EQ(log.sensors[2].role, "equipment");
  EXPECT_THAT(log.sensors[0].times_s, ElementsAre(0.0, 600.0));
  EXPECT_THAT(log.sensors[2].celsius, ElementsAre(21.0, 22.5));
  EXPECT_EQ(moment_text(*log.begin), "2026-03-02T08:00:00");
  EXPECT_THAT(log.remarks, ElementsAre("temperature sensor \"Air\" is taken for one of the air by its name",
                                       "temperature sensor \"Bed\" is taken for one of the machine by its name",
                                       "temperature sensor \"Laser head\" is taken for one of the equipment by its "
                                       "name"));
}

TEST(TemperatureLogs, MayHaveDecimalCommasInQuotesBetweenCommas) {
  const auto log = log_of(
      "\"time\",\"Air, hall 2 [°C]\",\"Bed [°C]\"\n"
      "\"2026-03-02T08:00:00\",\"20,5\",\"21,25\"\n"
      "\"2026-03-02T08:10:00\",\"20,75\",21\n");
  ASSERT_EQ(log.sensors.size(), 2u);
  EXPECT_EQ(log.sensors[0].location, "Air, hall 2");
  EXPECT_THAT(log.sensors[0].celsius, ElementsAre(20.5, 20.75));
  EXPECT_THAT(log.sensors[1].celsius, ElementsAre(21.25, 21.0));
  EXPECT_NE(refusal("time_s,Air [°C]\n\"1,200\",\"20,5\"\n\"1,800\",\"20,5\"\n"), "read")
      << "1.2 s or 1200 s: nobody knows";
  const auto tabs =
      log_of("time\tAir [°C]\tBed [°C]\n2026-03-02T08:00:00\t\t\"21,25\"\n2026-03-02T08:10:00\t20,5\t\"21\"\n");
  EXPECT_THAT(tabs.sensors[1].celsius, ElementsAre(21.25, 21.0)) << "an empty cell in front of a quoted one is a cell";
}

TEST(TemperatureLogs, SayWhichTimeZoneIsNotRead) {
  using Case = std::pair<const char*, const char*>;
  for (const auto& [moment, zone] :
       {Case{"2026-03-02 09:00:00 CET", "CET"}, Case{"2026-03-02T09:00:00+25:00", "+25:00"},
        Case{"2026-03-02T09:00:00+14:30", "+14:30"}, Case{"2026-03-02T09:00:00[Europe/Berlin]", "[Europe/Berlin]"},
        Case{"02.03.2026 09:00 MEZ", "MEZ"}})
    EXPECT_EQ(
        refusal(fmt::format("time;Air [°C]\n{};20,5\n", moment)),
        fmt::format("line 2:1: found \"{}\" behind the time in \"{}\", expected nothing, or a time zone such as Z or "
                    "+01:00",
                    zone, moment));
  for (const char* log :
       {"time;timezone;Air [°C]\n2026-03-02 09:00:00;CET;20,5\n",
        "time;UTC offset;Air [°C]\n2026-03-02 09:00:00;1;20,5\n",
        "date;time;x;Air [°C]\n2026-01-01;10:00:00;+01:00;20,1\n", "2026-01-01 10:00:00;+01:00;20,1\n"})
    EXPECT_THAT(refusal(log), HasSubstr("in a column of its own")) << log;
  for (const char* log : {"time;timezone;Air [°C]\n2026-03-02T09:00:00Z;CET;20,5\n",
                          "time;timezone;Air [°C]\n2026-03-02 09:00:00;;20,5\n", "time_s;zone;Air [°C]\n0;1;20,5\n",
                          "start;2026-03-02 09:00;UTC\ntime;Air [°C]\n2026-03-02 09:00;20,5\n"})
    EXPECT_EQ(refusal(log), "read") << log;
  for (const char* zone : {"Z", "MEZ", "CET", "CEST", "Europe/Berlin", "America/Argentina/Buenos_Aires", "UTC+1",
                           "GMT-7", "UTC +01:00", "+0100", "-0330"})
    for (const char* head : {"Info", "Offset", ""})
      for (const char* unit : {" [°C]", ""})
        EXPECT_THAT(refusal(fmt::format("time;{};Air{}\n2026-03-02 09:00:00;{};20,5\n", head, unit, zone)),
                    HasSubstr(fmt::format("found the time zone \"{}\" in a column of its own", zone)))
            << head << unit;
  EXPECT_THAT(refusal("2026-03-02 09:00:00;+0100;20,1\n"), HasSubstr("\"+0100\" in a column of its own (column 2)"));
  EXPECT_THAT(refusal("date time tz air\n2026-03-02 09:00:00 CET 20.5\n"), HasSubstr("(\"tz\")"));
  for (const char* head : {"tz", "Info", ""})
    EXPECT_THAT(
        refusal(fmt::format("time;{};Air [°C]\n2026-03-02 09:00:00;;20,5\n2026-03-02 09:10:00;CET;20,5\n", head)),
        HasSubstr("line 3:1: found the time zone \"CET\" in a column of its own"))
        << head;
  for (const char* column : {"logger;UTC-Logger 3", "logger;GMT-7", "Info;UTC-Logger 3", "Info;GMT-room", "axis;Z",
                             "Info;on/off", "Info;Air/Hall", "Info;-1000", "Torque;+1200 Nm", "Info;zone 1"}) {
    const std::string_view whole = column;
    const std::size_t at = whole.find(';');
    EXPECT_EQ(refusal(fmt::format("time;{};Air [°C]\n2026-03-02 09:00:00;{};20,5\n", whole.substr(0, at),
                                  whole.substr(at + 1))),
              "read")
        << column;
  }
  EXPECT_EQ(refusal("time;T1 [0.1 °C];Air [°C]\n2026-03-02 09:00:00;+0200;20,5\n"), "read");
  EXPECT_EQ(refusal("Exported 2026-03-02 09:00 CET\ntime;Air [°C]\n2026-03-02 09:00;20,5\n"), "read");
}

TEST(TemperatureLogs, MayHaveDecimalCommasSemicolonsGermanDatesAndAPreamble) {
  const auto log = log_of(
      "Datenlogger 4711\r\nIntervall: 10 min\r\n"
      "Datum;Uhrzeit;Hallenluft [°C];Feuchte [%]\r\n"
      "01.03.2026;23:50:00;19,5;41\r\n02.03.2026;00:00:00;19,75;42\r\n");
  ASSERT_EQ(log.sensors.size(), 1u);
  EXPECT_THAT(log.sensors[0].times_s, ElementsAre(0.0, 600.0));
  EXPECT_THAT(log.sensors[0].celsius, ElementsAre(19.5, 19.75));
  EXPECT_EQ(moment_text(*log.begin), "2026-03-01T23:50:00");
  EXPECT_THAT(log.remarks, Contains("column \"Feuchte [%]\" of the temperature log does not say that it is a "
                                    "temperature and is passed over"));
}

TEST(TemperatureLogs, MayHaveDatesWithSlashesAboveTheReadings) {
  for (const char* above : {"Exported,3/2/2026", "Exported,3/2/2026,12", "Exported 3/2/2026 14:05 by logger 7"}) {
    const auto log = log_of(fmt::format("{}\ntime,air [°C]\n2026-03-02T09:00,20\n2026-03-02T09:10,20.1\n", above));
    ASSERT_EQ(log.sensors.size(), 1u) << above;
    EXPECT_THAT(log.sensors[0].celsius, ElementsAre(20, 20.1)) << above;
  }
  for (const char* reading : {"3/2/2026 08:00,20", "3/2/2026,08:00,20", "1,3/2/2026 08:00,20"})
    EXPECT_THAT(refusal(fmt::format("{}\n", reading)), HasSubstr("of slashes nobody knows")) << reading;
}

TEST(TemperatureLogs, TakeKelvinAndFahrenheitToCelsius) {
  const auto log = log_of("time_s,room_K,bed_degF\n0,293.15,68\n60,295.15,77\n");
  EXPECT_THAT(log.sensors[0].celsius, ElementsAre(DoubleNear(20.0, 1e-9), DoubleNear(22.0, 1e-9)));
  EXPECT_THAT(log.sensors[1].celsius, ElementsAre(DoubleNear(20.0, 1e-9), DoubleNear(25.0, 1e-9)));
  EXPECT_FALSE(log.begin) << "seconds tell no date";
}

TEST(TemperatureLogs, TakeALastLetterForAUnitOnlyWhereAllHaveOne) {
  const auto names = [](const TemperatureLog& log) {
    std::vector<std::string> all;
    for (const TemperatureCourse& sensor : log.sensors) all.push_back(sensor.location);
    return all;
  };
  const std::string rows = "2026-03-02 09:00;30.1;30;20\n2026-03-02 09:10;30.1;30;20\n";
  EXPECT_THAT(names(log_of("time;Air A;Air B;Air C\n" + rows)), ElementsAre("Air A", "Air B", "Air C"));
  EXPECT_THAT(names(log_of("time;Air (A);Air (B);Air (C)\n" + rows)), ElementsAre("Air (A)", "Air (B)", "Air (C)"));
  EXPECT_THAT(names(log_of("time;Air (hall 2);Air;Bed\n" + rows)), ElementsAre("Air (hall 2)", "Air", "Bed"));
  const auto fahrenheit = log_of("time_s;Air_F\n0;68\n60;77\n");
  EXPECT_THAT(fahrenheit.sensors[0].celsius, ElementsAre(DoubleNear(20.0, 1e-9), DoubleNear(25.0, 1e-9)));
  EXPECT_THAT(fahrenheit.remarks, Contains("column \"Air_F\" of the temperature log is taken to be in °F by its last "
                                           "letter"));
  EXPECT_THAT(refusal("time;Air_F;Air;Bed\n" + rows), HasSubstr("nobody knows whether the last letter is one"));
}

TEST(TemperatureLogs, TakeLettersForUnitsBesideWhatIsNoSensor) {
  const auto read = [](std::string_view head, std::string_view cells) {
    const auto log = log_of(fmt::format("time,{0}\n2026-03-02 09:00,{1}\n2026-03-02 09:10,{1}\n", head, cells));
    std::string text;
    for (const TemperatureCourse& s : log.sensors) text += fmt::format("{} {:.1f};", s.location, s.celsius.front());
    return text;
  };
  EXPECT_EQ(read("Air_F,Bed_F,comment", "68,77,"), "Air 20.0;Bed 25.0;");
  EXPECT_EQ(read("Air_F,Bed_F,RSSI", "68,77,-60"), "Air 20.0;Bed 25.0;");
  EXPECT_EQ(read("S1_F,S2_F,RSSI", "68,77,-60"), "S1 20.0;S2 25.0;");
  EXPECT_EQ(read("Air_C,Bed_C,Door", "20,21,1"), "Air 20.0;Bed 21.0;");
  EXPECT_EQ(read("Air_C,Door", "20,1"), "Air 20.0;");
  const auto door = log_of("time,Air_C,Door\n2026-03-02 09:00,20,1\n2026-03-02 09:10,20,0\n");
  EXPECT_THAT(door.remarks, Contains("column \"Door\" of the temperature log does not say that it is a temperature and "
                                     "is passed over"));
  // Front and rear, or a sensor without a letter: nobody knows.
  for (const char* head : {"Bed F,Bed R,Roof F,Roof R", "S1 F,S1 R,S2 F,S2 R", "T_F,T_R,T_L,RSSI",
                           "Air_F,Bed_F,T3,RSSI", "Wall_R,Bed_F,Air_F,RSSI", "Left F,Door,RSSI,Rain"})
    EXPECT_THAT(refusal(fmt::format("time,{}\n2026-03-02 09:00,68,70,71,72\n", head)),
                HasSubstr("nobody knows whether the last letter is one"))
        << head;
}

TEST(TemperatureLogs, CountSensorsByNameThatTellNoUnitBesideOthers) {
  const auto log = log_of("time_s;Air [°C];Hall 2;Status;Humidity\n0;20;30;1;40\n60;20;30;1;41\n");
  ASSERT_EQ(log.sensors.size(), 2u);
  EXPECT_EQ(log.sensors[1].location, "Hall 2");
  EXPECT_THAT(log.remarks, Contains(HasSubstr("\"Hall 2\" of the temperature log tells no unit, which others do")));
  EXPECT_THAT(log.remarks, Contains(HasSubstr("\"Status\" of the temperature log does not say")));
}

TEST(TemperatureLogs, LoseNoReadingToAHead) {
  const auto log = log_of("time;Air (hall 2)\n2026-03-02 09:00;30.1\n2026-03-02 09:10;20.1\n");
  EXPECT_EQ(log.sensors[0].location, "Air (hall 2)");
  EXPECT_THAT(log.sensors[0].celsius, ElementsAre(30.1, 20.1));
  const auto late = log_of("time;Air;Bed\n2026-03-02 09:00;err;err\n2026-03-02 09:10;20.1;20.2\n");
  EXPECT_EQ(late.sensors[1].location, "Bed");
  const auto bare = log_of("2026-03-02 09:00;20\n2026-03-02 09:10;21\n");
  EXPECT_THAT(bare.sensors[0].celsius, ElementsAre(20, 21));
  EXPECT_EQ(bare.sensors[0].location, "column 2");
}

TEST(TemperatureLogs, KeepASensorThatNeverDelivered) {
  const auto log = log_of("time;Air [°C];Hall [°C]\n2026-03-02 09:00;20;err\n2026-03-02 09:10;20;-127\n");
  ASSERT_EQ(log.sensors.size(), 2u);
  EXPECT_EQ(log.sensors[1].role, "air");
  EXPECT_THAT(log.sensors[1].celsius, IsEmpty());
  EXPECT_THAT(log.remarks, Contains("temperature sensor \"Hall\" has no reading at all"));
  EXPECT_THAT(refusal("time;Air [°C]\n2026-03-02 09:00;err\n2026-03-02 09:10;err\n"),
              HasSubstr("found no temperature in the temperature log"));
}

/// All of its temperatures would be within any limit, and its change none.
TEST(TemperatureLogs, TellOfASensorThatShowsNoChange) {
  const auto text_of = [](int still_from, int readings) {
    std::string text = "time;Air [°C]\n";
    for (int j = 0; j < readings; ++j)
      text += fmt::format("2026-03-02 {:02}:{:02};{}\n", j / 6, 10 * (j % 6),
                          j < still_from ? fmt::format("20.{:02}", j % 7) : "20.31");
    return text;
  };
  EXPECT_THAT(log_of(text_of(40, 90)).remarks,
              Contains("temperature sensor \"Air\" shows 20.31 °C in 50 readings over 8.2 h without any change: it "
                       "hangs, or its steps are coarse"));
  EXPECT_THAT(log_of(text_of(0, 37)).remarks, Contains(HasSubstr("in 37 readings over 6.0 h without any change")));
  EXPECT_THAT(log_of(text_of(60, 90)).remarks, Not(Contains(HasSubstr("without any change"))));
}

TEST(TemperatureLogs, TellWhatTheyAssumeAndLeaveOut) {
  const auto log =
      log_of("time,T1,humidity\n2026-03-02 08:00,20.1,40\n2026-03-02 08:10,-127,41\n2026-03-02 08:20,,42\n");
  EXPECT_THAT(log.sensors[0].celsius, ElementsAre(20.1));
  EXPECT_THAT(log.remarks, Contains(HasSubstr("\"T1\": 1 of 3 readings have no value")));
  EXPECT_THAT(log.remarks, Contains(HasSubstr("\"T1\": 1 of 3 readings lie outside −60 … 100 °C")));
  EXPECT_THAT(log.remarks, Contains(HasSubstr("\"T1\" does not say what it is of and is taken for one of the air")));
  EXPECT_THAT(log.remarks, Contains(HasSubstr("tells no unit of its temperatures")));
  EXPECT_THAT(log.remarks,
              Contains(HasSubstr("column \"humidity\" of the temperature log does not say that it is a temperature")));
}

TEST(TemperatureLogs, SeekWordsAndNoPartsOfThem) {
  const auto role = [](std::string_view name) {
    const auto log = log_of(fmt::format("time_s;{}\n0;20\n60;21\n", name));
    return log.remarks.front().find("does not say") != std::string::npos ? "not told" : log.sensors[0].role;
  };
  for (const char* air : {"air", "Air_2", "T1Air", "airTemp", "Hallenluft", "Außenlufttemperatur", "Raumtemperatur",
                          "Maschinenraum", "air above the bed"})
    EXPECT_EQ(role(air), "air") << air;
  for (const char* machine : {"bed_left", "Maschinenbett", "Drehtisch", "ballscrew", "Rundtischtemp", "spindle2"})
    EXPECT_EQ(role(machine), "machine") << machine;
  for (const char* unknown : {"fairing", "stable support", "sidewall", "compressor", "counterweight", "Tauchfühler",
                              "embedded", "Presse", "indexer"})
    EXPECT_EQ(role(unknown), "not told") << unknown;
  for (const char* other : {"humidity", "air_RH", "Luftfeuchte", "Luftdruck", "Drucktaupunkt", "airhumidity",
                            "dew point", "airPressure", "sample count", "Seriennummer", "CO2", "battery", "No."}) {
    const auto log = log_of(fmt::format("time_s;{};air\n0;20;20\n60;21;20\n", other));
    EXPECT_EQ(log.sensors.size(), 1u) << other;
    EXPECT_THAT(log.remarks, Contains(HasSubstr("does not say that it is a temperature"))) << other;
  }
  const auto both = log_of("time_s,air left,air right\n0,20,21\n60,20,21\n");
  EXPECT_THAT(both.remarks, Contains("temperature sensors \"air left\", \"air right\" are taken for ones of the air by "
                                     "their names"));
}

TEST(TemperatureLogs, TakeTheRolesThatAreStated) {
  const std::string text = "time_s,T1_C,T2_C\n0,20,21\n60,20,21\n";
  const auto log = log_of(text, {{"T1", "Machine"}, {"T2", "air"}});
  EXPECT_EQ(log.sensors[0].role, "machine");
  EXPECT_THAT(log.remarks, IsEmpty());
  EXPECT_THAT(refusal(text, {{"T3", "air"}}), HasSubstr("found no sensor \"T3\""));
  EXPECT_THAT(refusal(text, {{"T1", "machine"}, {"T1", "air"}}),
              HasSubstr("found two roles of the sensor \"T1\", expected one"));
  EXPECT_THAT(refusal(text, {{"T1", "floor"}}), HasSubstr("expected machine, equipment, air or none"));
}

TEST(TemperatureLogs, LeaveOutTemperaturesOfNothingThatTheyAreFor) {
  for (const char* head : {"Dew Pt [C]", "Air dew point [°C]", "Taupunkt Luft [°C]", "Set point [C]", "Raum Soll [°C]",
                           "Air max alarm [C]", "Coolant [C]", "Oil [C]", "Kühlmittel [°C]", "Öl [°C]"}) {
    const std::string text = fmt::format("time;{};Air [C]\n2026-03-02 09:00;7.8;20\n2026-03-02 09:10;7.9;20\n", head);
    const auto log = log_of(text);
    ASSERT_EQ(log.sensors.size(), 1u) << head;
    EXPECT_EQ(log.sensors[0].location, "Air");
    EXPECT_THAT(log.remarks, Contains(HasSubstr("is by its name no temperature of the machine"))) << head;
  }
  const std::string text = "time_s;Oil [C];Outside [C]\n0;20;5\n60;21;5\n";
  const auto stated = log_of(text, {{"Oil", "machine"}, {"Outside", "none"}});
  ASSERT_EQ(stated.sensors.size(), 1u);
  EXPECT_EQ(stated.sensors[0].role, "machine");
  EXPECT_THAT(stated.remarks, IsEmpty());
  EXPECT_THAT(refusal(text, {{"Outside", "none"}}), HasSubstr("expected one of \"Oil\", \"Outside\" to be stated"));
}

TEST(TemperatureLogs, NameTheirSensorsWhateverTheirNamesTell) {
  const std::string text = "Logger 7\ntime_s;Oil [C];Air [C];RSSI\n0;err;5;1\n60;21;5;1\n";
  const auto sensors = sensors_of_log(text);
  ASSERT_TRUE(sensors) << sensors.error().to_string();
  EXPECT_THAT(*sensors, ElementsAre("Oil", "Air"));
  EXPECT_THAT(*sensors_of_log("time_s;Oil [C];KSS [C]\n0;20;5\n"), ElementsAre("Oil", "KSS"));
  EXPECT_FALSE(sensors_of_log("these are\nno temperatures\n"));
}

TEST(TemperatureLogs, TakeNoNumberForATemperatureThatItsHeadTellsOtherwise) {
  for (const char* heads : {"Humidity;Pressure", "Humidity [%];Pressure [hPa]", "RSSI [V];Lux [lx]"}) {
    const std::string said = refusal(fmt::format("time;{}\n2026-03-02 09:00;40;30\n2026-03-02 09:10;41;31\n", heads));
    EXPECT_THAT(said, HasSubstr("beside the time in a temperature log, expected a column that says")) << heads;
    EXPECT_THAT(said, HasSubstr(std::string(heads).substr(0, 4))) << heads;
  }
  EXPECT_THAT(refusal("Datum;Uhrzeit;Feuchte\n2026-03-02;09:00;40\n2026-03-02;09:10;41\n"),
              HasSubstr("found \"Feuchte\" beside"));
  const auto below = log_of("Start time;Battery [V]\n2026-03-02 09:00;3.3\ntime;Air [C]\n2026-03-02 09:00;20\n");
  EXPECT_EQ(below.sensors[0].location, "Air");
  const auto late = log_of("time;Air [C]\n2026-03-02 09:00;warming up\n2026-03-02 09:10;20\n");
  EXPECT_EQ(late.sensors[0].location, "Air");
}

TEST(TemperatureLogs, MayBeginWithTheNewestReadingOrHaveNoDate) {
  const auto turned = log_of("time;air [°C]\n2026-03-02 08:20;22\n2026-03-02 08:10;21\n2026-03-02 08:00;20\n");
  EXPECT_THAT(turned.sensors[0].celsius, ElementsAre(20, 21, 22));
  EXPECT_THAT(turned.sensors[0].times_s, ElementsAre(0, 600, 1200));
  EXPECT_EQ(moment_text(*turned.begin), "2026-03-02T08:00:00");
  EXPECT_THAT(turned.remarks, Contains(HasSubstr("newest reading")));
  const auto night = log_of("time;air [°C]\n23:50;20\n00:10;21\n00:30;22\n");
  EXPECT_THAT(night.sensors[0].times_s, ElementsAre(0, 1200, 2400));
  EXPECT_FALSE(night.begin);
  const auto blanks = log_of("2026-03-02 08:00:00 20.5\n2026-03-02 08:01:00 20.6\n");
  EXPECT_THAT(blanks.sensors[0].celsius, ElementsAre(20.5, 20.6));
  const auto german = log_of("02.03.2026 08:00 20.5\n02.03.2026 08:01 20.6\n");
  EXPECT_THAT(german.sensors[0].times_s, ElementsAre(0, 60));
  const auto unix_times = log_of("epoch time,air_C\n1772438400,20\n1772438460,21\n");
  EXPECT_EQ(moment_text(*unix_times.begin), "2026-03-02T08:00:00Z");
  EXPECT_THAT(unix_times.remarks, Contains(HasSubstr("1970")));
}

TEST(TemperatureLogs, MayLastForCenturiesAndRefuseWhatLiesBeyond) {
  const auto old = log_of("time;air [°C]\n1900-01-01T00:00;20\n2199-12-31T00:00;21\n");
  EXPECT_THAT(old.sensors[0].times_s, ElementsAre(0, 109572.0 * 86400.0));
  EXPECT_THAT(old.remarks, Not(Contains(HasSubstr("newest reading"))));
  const auto turned = log_of("time;air [°C]\n2199-12-31T00:00;21\n1900-01-01T00:00;20\n");
  EXPECT_EQ(moment_text(*turned.begin), "1900-01-01T00:00:00");
  EXPECT_THAT(refusal("time;air [°C]\n1700000000;20\n1700000600;20.1\n900000000000000;21\n"),
              HasSubstr("4:1: found \"900000000000000;21\""));
}

TEST(TemperatureLogs, SayThatHalvesOfTheDayAreNotRead) {
  for (const char* reading :
       {"2026-03-02,11:00:00 AM,20.1", "2026-03-02 1:00 p.m.,20.1", "11:00 PM,20.1", "2026-03-02 11:00:00 AM 20.1"})
    EXPECT_THAT(refusal(fmt::format("Date,Time,Air (C)\n{}\n", reading)), HasSubstr("AM and PM are not read"))
        << reading;
  const auto log = log_of("Started,11:00 AM,12\ntime,air [°C]\n2026-03-02T09:00,20\n2026-03-02T09:10,20.1\n");
  EXPECT_EQ(log.sensors.size(), 1u);
}

TEST(TemperatureLogs, RefuseWhatNobodyCanKnow) {
  EXPECT_THAT(refusal(""), Not(HasSubstr("read")));
  EXPECT_THAT(refusal("hello\nworld\n"), HasSubstr("expected a temperature log"));
  EXPECT_THAT(refusal("time,air_C\n3/2/2026 08:00,20\n"), HasSubstr("of slashes nobody knows which is the month"));
  EXPECT_THAT(refusal("time,sensor,value\n2026-03-02 08:00,T1,20\n"), HasSubstr("expected a column for each sensor"));
  EXPECT_THAT(refusal("time_s,air_C\n0,20\n120,21\n60,22\n"), HasSubstr("4:1: found a time before that of the line"));
  EXPECT_THAT(refusal("time_s,air_C\n0,20\n60,warm\n"), HasSubstr("3:4: found \"warm\", expected a temperature"));
  EXPECT_THAT(refusal("time_s,air_C\n0,20\nend of log\n"), HasSubstr("3:1: found \"end of log\""));
  EXPECT_THAT(refusal("time_s,air_C\n0,err\n60,20\n120,\n"), "read");
  EXPECT_THAT(refusal("time,air_C\n2026-03-02T08:00Z,20\n2026-03-02T08:10,20\n"), HasSubstr("3:1: found"));
}

TEST(TemperatureLogs, TakeNoNumberOfAnythingElseForATemperature) {
  const char* const none = "beside the time in a temperature log, expected a column that says that it is a temperature";
  for (const char* head : {"time;Humidity [%]", "time;Position [mm]", "time;CO2", "time;position_mm", "time;Dev. um"}) {
    EXPECT_THAT(refusal(fmt::format("{}\n2026-03-02 09:00;41\n2026-03-02 09:10;42\n", head)), HasSubstr(none)) << head;
    EXPECT_THAT(refusal(fmt::format("{}\n09:00:00;41\n09:10:00;42\n", head)), HasSubstr(none)) << head;
  }
  EXPECT_THAT(refusal("time_s,position_mm\n0.000,0.21522\n0.005,0.21489\n"), HasSubstr(none));
  const auto log = log_of("started;Battery [V]\n2026-03-02 08:50;3.6\ntime;air\n2026-03-02 09:00;20\n");
  EXPECT_THAT(log.sensors[0].celsius, ElementsAre(20)) << "what stands above the readings";
}

TEST(TemperatureLogs, CostInProportionToTheirLength) {
  const auto text = [](std::size_t lines) {
    std::string all = "time_s,air_C\n";
    for (std::size_t k = 0; k < lines; ++k) all += fmt::format("{},{}\n", k, 20 + k % 7);
    return all;
  };
  for (const std::size_t lines : {100u, 1000u, 100000u})
    EXPECT_EQ(log_of(text(lines)).sensors[0].celsius.size(), lines);
  EXPECT_THAT(refusal("time_s,air_C\n0,20\n" + std::string(20000, '7') + "\n"),
              HasSubstr("3:1: found a line of 20000"));
  std::string preamble;
  for (int k = 0; k < 100000; ++k) preamble += "about this logger\n";
  EXPECT_THAT(refusal(preamble + text(3)), HasSubstr("expected a temperature log")) << "a preamble ends somewhere";
}

}  // namespace
}  // namespace axiometry::formats
