--  SPDX-License-Identifier: GPL-3.0-or-later

with Ada.Calendar;      use Ada.Calendar;
with Ada.Exceptions;
with Ada.Streams;       use Ada.Streams;
with Ada.Strings.Fixed; use Ada.Strings.Fixed;

package body I_Robot is

   package Serials renames GNAT.Serial_Communications;
   package Sockets renames GNAT.Sockets;

   --  How long the robot may be silent, and a whole packet of the handshake may take.
   Patience : constant Duration := 2.0;

   --  Of id and data: the sum of big-endian pairs; the last byte is xored if it is left alone.
   function Checksum (Packet_Body : Bytes) return Unsigned_16 is
      Total : Unsigned_16 := 0;
      I     : Natural     := Packet_Body'First;
   begin
      while I < Packet_Body'Last loop
         Total := Total + Unsigned_16 (Packet_Body (I)) * 256 + Unsigned_16 (Packet_Body (I + 1));
         I     := I + 2;
      end loop;
      if I = Packet_Body'Last then
         Total := Total xor Unsigned_16 (Packet_Body (I));
      end if;
      return Total;
   end Checksum;

   function Framed (Packet_Body : Bytes) return Bytes is
      Check : constant Unsigned_16 := Checksum (Packet_Body);
   begin
      return (16#FA#, 16#FB#, Unsigned_8 (Packet_Body'Length + 2)) & Packet_Body &
             (Unsigned_8 (Check / 256), Unsigned_8 (Check mod 256));
   end Framed;

   function Output_Gen (Command : Unsigned_8) return Bytes is (Framed ((0 => Command)));

   function Output_Gen (Command : Unsigned_8; Argument : Integer) return Bytes is
      Magnitude : constant Unsigned_16 := Unsigned_16 (Integer'Min (abs Argument, 32_767));
   begin
      return Framed
        ((Command, (if Argument >= 0 then 16#3B# else 16#1B#),
          Unsigned_8 (Magnitude mod 256), Unsigned_8 (Magnitude / 256)));
   end Output_Gen;

   function Output_Gen (Command : Unsigned_8; Left, Right : Integer) return Bytes is
      function Clipped (Value : Integer) return Integer is (Integer'Max (-127, Integer'Min (127, Value)));
      Both : constant Integer := Clipped (Left) * 256 + Clipped (Right) mod 256;
   begin
      return Output_Gen (Command, Both);
   end Output_Gen;

   function Word (Packet : Bytes; At_Byte : Natural) return Integer is
      Value : constant Integer := Integer (Packet (At_Byte)) + 256 * Integer (Packet (At_Byte + 1));
   begin
      return (if Value < 32_768 then Value else Value - 65_536);
   end Word;

   protected body State is

      procedure Start (Name, Class_Type : String) is
      begin
         Known            := (others => <>);
         Known.Name       := To_Unbounded_String (Name);
         Known.Class_Type := To_Unbounded_String (Class_Type);
      end Start;

      --  Fields of a packet that is too short keep their values.
      procedure Take (Packet : Bytes) is
         --  From one position to the next the 16 bits of the wire have wrapped at most once.
         function Step (From, To : Integer) return Integer is
           ((To - From + 32_768) mod 65_536 - 32_768);
      begin
         if Packet'Length < 20 then
            return;
         end if;
         if Known.States > 0 then
            Known.X := Known.X + Step (Known.Last_X, Word (Packet, 1));
            Known.Y := Known.Y + Step (Known.Last_Y, Word (Packet, 3));
         else
            Known.X := Word (Packet, 1);
            Known.Y := Word (Packet, 3);
         end if;
         Known.Last_X  := Word (Packet, 1);
         Known.Last_Y  := Word (Packet, 3);
         Known.Heading := Float (Word (Packet, 5)) * 360.0 / 4_096.0;
         Known.Left    := Word (Packet, 7);
         Known.Right   := Word (Packet, 9);
         Known.Battery := Float (Packet (11)) / 10.0;
         Known.Stall   := (Packet (12) and 1) /= 0 or else (Packet (13) and 1) /= 0;
         Known.Motors  := (Packet (16) and 1) /= 0;
         for I in 0 .. Natural (Packet (19)) - 1 loop
            exit when 22 + 3 * I > Packet'Last;
            declare
               Number : constant Natural := Natural (Packet (20 + 3 * I));
               Length : constant Natural :=
                 Natural (Packet (21 + 3 * I)) + 256 * Natural (Packet (22 + 3 * I));
            begin
               if Number in Ranges'Range then
                  Known.Sonars (Number) := Natural'Min (Length, No_Echo);
               end if;
            end;
         end loop;
         Known.States := Known.States + 1;
      end Take;

      function Get return Values is (Known);

   end State;

   protected body Mutex is
      entry Seize when not Held is
      begin
         Held := True;
      end Seize;
      procedure Release is
      begin
         Held := False;
      end Release;
   end Mutex;

   --  The next byte; raises Robot_Error when none comes in time, or when the line is closed.
   function Next_Byte (R : in out Robot; Until_Time : Time) return Unsigned_8 is
      Buffer : Stream_Element_Array (1 .. 1);
      Last   : Stream_Element_Offset;
   begin
      loop
         if R.Kind = Socket then
            Sockets.Receive_Socket (R.Line, Buffer, Last);
            if Last < Buffer'First then
               raise Robot_Error with "the robot has closed the connection";
            end if;
         else
            R.Tty.Read (Buffer, Last);
         end if;
         if Last = Buffer'Last then
            return Unsigned_8 (Buffer (1));
         end if;
         if Clock > Until_Time then
            raise Robot_Error with "the robot does not answer";
         end if;
      end loop;
   exception
      when Sockets.Socket_Error =>
         raise Robot_Error with "the robot does not answer, or the connection is lost";
      when Serials.Serial_Error =>
         raise Robot_Error with "the serial line is gone: was it unplugged?";
   end Next_Byte;

   --  Id and data of the next packet; what is no packet is skipped.
   function Receive (R : in out Robot) return Bytes is
      Until_Time   : constant Time := Clock + Patience;
      Before, Here : Unsigned_8    := 0;
   begin
      loop
         Here := Next_Byte (R, Until_Time);
         if Before = 16#FA# and then Here = 16#FB# then
            declare
               Count  : constant Natural := Natural (Next_Byte (R, Until_Time));
               Packet : Bytes (0 .. Natural'Max (Count, 3) - 1);
            begin
               if Count >= 3 then
                  for B of Packet loop
                     B := Next_Byte (R, Until_Time);
                  end loop;
                  if Checksum (Packet (0 .. Count - 3)) =
                    Unsigned_16 (Packet (Count - 2)) * 256 + Unsigned_16 (Packet (Count - 1))
                  then
                     return Packet (0 .. Count - 3);
                  end if;
               end if;
            end;
            Here := 0;
         end if;
         Before := Here;
         if Clock > Until_Time then
            raise Robot_Error with "nothing that comes is a packet: is this the robot's line, and its speed?";
         end if;
      end loop;
   end Receive;

   procedure Write_Data (R : in out Robot; Packet : Bytes) is
      Buffer : Stream_Element_Array (1 .. Packet'Length);
   begin
      if not R.Connected then
         raise Robot_Error with "the robot is not connected";
      end if;
      for I in Packet'Range loop
         Buffer (Stream_Element_Offset (I - Packet'First + 1)) := Stream_Element (Packet (I));
      end loop;
      R.Writing.Seize;
      begin
         if R.Kind = Socket then
            R.Channel.Write (Buffer);
         else
            R.Tty.Write (Buffer);
         end if;
      exception
         when Error : others =>
            R.Writing.Release;
            raise Robot_Error with "the line is lost: " & Ada.Exceptions.Exception_Message (Error);
      end;
      R.Writing.Release;
   end Write_Data;

   procedure Read_Data (R : in out Robot) is
   begin
      if not R.Connected then
         raise Robot_Error with "the robot is not connected";
      end if;
      loop
         declare
            Packet : constant Bytes := Receive (R);
         begin
            if Packet (0) in 16#32# | 16#33# then
               R.Now.Take (Packet);
               exit;
            end if;
         end;
      end loop;
      Write_Data (R, Output_Gen (Pulse));
   end Read_Data;

   --  The nth of the texts in the answer to the last SYNC, each ended by 0: name, class, type.
   function Text_Of (Packet : Bytes; Nth : Positive) return String is
      Result : Unbounded_String;
      Number : Positive := 1;
   begin
      for I in Packet'First + 1 .. Packet'Last loop
         if Packet (I) = 0 then
            Number := Number + 1;
         elsif Number = Nth then
            Append (Result, Character'Val (Packet (I)));
         end if;
      end loop;
      return To_String (Result);
   end Text_Of;

   --  A robot that is still connected from before sends states; it is told to close, and asked again.
   procedure Shake_Hands (R : in out Robot) is
      Tries : Natural    := 0;
      Sync  : Unsigned_8 := 0;
   begin
      loop
         Write_Data (R, Output_Gen (Sync));
         declare
            Packet : constant Bytes := Receive (R);
         begin
            if Packet (0) = Sync then
               if Sync = 2 then
                  R.Now.Start (Text_Of (Packet, 1), Text_Of (Packet, 3));
                  exit;
               end if;
               Sync := Sync + 1;
            else
               Tries := Tries + 1;
               if Packet (0) in 16#32# | 16#33# then
                  Write_Data (R, Output_Gen (Close));
               end if;
               Sync := 0;
            end if;
         end;
         if Tries > 10 then
            raise Robot_Error with "the robot answers, but does not shake hands";
         end if;
      end loop;
      Write_Data (R, Output_Gen (Open, 1));
   end Shake_Hands;

   procedure Open_Socket (R : in out Robot; Config : Configuration) is
      Address : Sockets.Sock_Addr_Type;
   begin
      Address.Addr := Sockets.Addresses (Sockets.Get_Host_By_Name (To_String (Config.Host)), 1);
      Address.Port := Sockets.Port_Type (Config.Port);
      Sockets.Create_Socket (R.Line);
      Sockets.Connect_Socket (R.Line, Address);
      Sockets.Set_Socket_Option
        (R.Line, Sockets.IP_Protocol_For_TCP_Level, (Sockets.No_Delay, True));
      Sockets.Set_Socket_Option
        (R.Line, Sockets.Socket_Level, (Sockets.Receive_Timeout, Timeout => Patience));
      R.Channel := Sockets.Stream (R.Line);
   exception
      when Error : Sockets.Socket_Error | Sockets.Host_Error =>
         raise Robot_Error with
           "no connection to " & To_String (Config.Host) & ": " & Ada.Exceptions.Exception_Message (Error);
   end Open_Socket;

   procedure Open_Serial (R : in out Robot; Config : Configuration) is
      Rate : constant Serials.Data_Rate :=
        (case Config.Baud is
           when 9_600 => Serials.B9600, when 19_200 => Serials.B19200, when 38_400 => Serials.B38400,
           when 57_600 => Serials.B57600, when 115_200 => Serials.B115200,
           when others => raise Robot_Error with "a robot's line has 9600, 19200, 38400, 57600 or 115200 baud");
   begin
      Serials.Open (R.Tty, Serials.Port_Name (To_String (Config.Device)));
      Serials.Set (R.Tty, Rate => Rate, Block => False, Timeout => 0.1);
   exception
      when Error : Serials.Serial_Error =>
         raise Robot_Error with
           To_String (Config.Device) & " cannot be opened: " & Ada.Exceptions.Exception_Message (Error);
   end Open_Serial;

   procedure Begin_Comm (R : in out Robot; Config : Configuration) is
   begin
      End_Comm (R);
      R.Kind := Config.Kind;
      case Config.Kind is
         when Socket =>
            Open_Socket (R, Config);
         when Serial =>
            Open_Serial (R, Config);
      end case;
      R.Connected := True;
      Shake_Hands (R);
   end Begin_Comm;

   procedure End_Comm (R : in out Robot) is
   begin
      if not R.Connected then
         return;
      end if;
      begin
         Write_Data (R, Output_Gen (Enable, 0));
         Write_Data (R, Output_Gen (Close));
      exception
         when Robot_Error =>
            null;  --  the line is gone, and with it the watchdog stops the robot
      end;
      R.Connected := False;
      if R.Kind = Socket then
         Sockets.Free (R.Channel);
         Sockets.Close_Socket (R.Line);
      else
         Serials.Close (R.Tty);
      end if;
   end End_Comm;

   overriding procedure Finalize (R : in out Robot) is
   begin
      End_Comm (R);
   exception
      when others =>
         null;  --  nothing more can be done for it
   end Finalize;

   function Number_Of (Text, What : String) return Positive is
   begin
      return Positive'Value (Text);
   exception
      when Constraint_Error =>
         raise Robot_Error with "'" & Text & "' is not the " & What & " of a robot's address";
   end Number_Of;

   function Configuration_Of (Url : String) return Configuration is
      function Without (Prefix : String) return String is
        (if Index (Url, Prefix) = Url'First then Url (Url'First + Prefix'Length .. Url'Last) else Url);
   begin
      if Index (Url, "serial://") = Url'First or else (Url'Length > 0 and then Url (Url'First) = '/') then
         declare
            Rest  : constant String  := Without ("serial://");
            Speed : constant Natural := Index (Rest, "?baud=");
         begin
            return
              (Kind   => Serial,
               Device => To_Unbounded_String (Rest (Rest'First .. (if Speed > 0 then Speed - 1 else Rest'Last))),
               Baud   => (if Speed > 0 then Number_Of (Rest (Speed + 6 .. Rest'Last), "speed") else 9_600));
         end;
      end if;
      declare
         Rest  : constant String  := Without ("tcp://");
         Colon : constant Natural := Index (Rest, ":");
      begin
         return
           (Kind => Socket,
            Host => To_Unbounded_String (Rest (Rest'First .. (if Colon > 0 then Colon - 1 else Rest'Last))),
            Port => (if Colon > 0 then Number_Of (Rest (Colon + 1 .. Rest'Last), "port") else 8_101));
      end;
   end Configuration_Of;

   function Get_Name (R : Robot) return String is (To_String (R.Now.Get.Name));
   function Get_Type (R : Robot) return String is (To_String (R.Now.Get.Class_Type));
   function Get_Pos_X (R : Robot) return Integer is (R.Now.Get.X);
   function Get_Pos_Y (R : Robot) return Integer is (R.Now.Get.Y);
   function Get_Heading (R : Robot) return Float is (R.Now.Get.Heading);
   function Get_Vel (R : Robot) return Integer is ((R.Now.Get.Left + R.Now.Get.Right) / 2);
   function Get_Vel_Left (R : Robot) return Integer is (R.Now.Get.Left);
   function Get_Vel_Right (R : Robot) return Integer is (R.Now.Get.Right);
   function Get_Battery (R : Robot) return Float is (R.Now.Get.Battery);
   function Get_Motors (R : Robot) return Boolean is (R.Now.Get.Motors);
   function Get_Stall (R : Robot) return Boolean is (R.Now.Get.Stall);
   function Get_Sonars (R : Robot) return Ranges is (R.Now.Get.Sonars);
   function Get_States (R : Robot) return Natural is (R.Now.Get.States);

   function Get_Sonar (R : Robot; Number : Natural) return Natural is
     (if Number in Ranges'Range then R.Now.Get.Sonars (Number) else No_Echo);

   function Get_Nearest (R : Robot; From, To : Natural) return Natural is
      Nearest : Natural := No_Echo;
   begin
      for Number in From .. To loop
         Nearest := Natural'Min (Nearest, Get_Sonar (R, Number));
      end loop;
      return Nearest;
   end Get_Nearest;

end I_Robot;
