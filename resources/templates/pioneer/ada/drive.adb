--  SPDX-License-Identifier: GPL-3.0-or-later
--  Drives a Pioneer: straight on, and turning where sonars hear something ahead. A loop of sensing, planning and
--  acting; the same for a simulated robot and a real one.
--
--  Usage: drive [tcp://localhost:8101 | serial:///dev/ttyUSB0?baud=9600] [SECONDS]      Build: gnatmake drive.adb

with Ada.Calendar;     use Ada.Calendar;
with Ada.Command_Line; use Ada.Command_Line;
with Ada.Exceptions;
with Ada.Text_IO;      use Ada.Text_IO;
with I_Robot;          use I_Robot;

procedure Drive is

   procedure Run (Url : String; Seconds : Duration) is
      R      : Robot;
      Finish : Time;
   begin
      Begin_Comm (R, Configuration_Of (Url));
      Put_Line ("connected with a " & Get_Type (R));
      Write_Data (R, Output_Gen (Enable, 1));
      Write_Data (R, Output_Gen (Sonar, 1));
      Finish := Clock + Seconds;
      while Clock < Finish loop
         Read_Data (R);                                --  sense
         if Get_Nearest (R, 2, 5) > 1_000 then         --  plan: mm
            Write_Data (R, Output_Gen (Vel, 250));     --  act: mm/s
            Write_Data (R, Output_Gen (Rvel, 0));
         else
            Write_Data (R, Output_Gen (Vel, 0));
            Write_Data (R, Output_Gen (Rvel, 30));     --  degrees/s
         end if;
      end loop;
      Put_Line ("at" & Integer'Image (Get_Pos_X (R)) & " mm," & Integer'Image (Get_Pos_Y (R)) & " mm after" &
                Natural'Image (Get_States (R)) & " states");
      End_Comm (R);
   end Run;

begin
   Run ((if Argument_Count > 0 then Argument (1) else "tcp://localhost:8101"),
        (if Argument_Count > 1 then Duration'Value (Argument (2)) else 30.0));
exception
   when Error : others =>
      Put_Line (Standard_Error, "the robot cannot be driven: " & Ada.Exceptions.Exception_Message (Error));
      Set_Exit_Status (Failure);
end Drive;
