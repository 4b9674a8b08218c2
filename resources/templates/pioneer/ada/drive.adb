--  SPDX-License-Identifier: GPL-3.0-or-later
--  Drives a Pioneer over its ARCOS port with nothing but GNAT's sockets: straight on, and turning where sonars hear
--  something ahead. A task of its own reads, the main program decides each 100 ms; they meet in a protected object.
--
--  Usage: drive [tcp://localhost:8101] [SECONDS]      Build: gnatmake drive.adb

with Ada.Calendar;          use Ada.Calendar;
with Ada.Command_Line;      use Ada.Command_Line;
with Ada.Exceptions;
with Ada.Streams;           use Ada.Streams;
with Ada.Strings.Fixed;
with Ada.Text_IO;           use Ada.Text_IO;
with GNAT.Sockets;          use GNAT.Sockets;
with Interfaces;            use Interfaces;

procedure Drive is

   type Bytes is array (Natural range <>) of Unsigned_8;

   --  Commands of ARCOS; 0 to 2 are the handshake before they are PULSE, OPEN and CLOSE.
   Pulse  : constant := 0;
   Open   : constant := 1;
   Close  : constant := 2;
   Enable : constant := 4;
   Vel    : constant := 11;
   Rvel   : constant := 21;
   Sonar  : constant := 28;

   Line    : Socket_Type;
   Channel : Stream_Access;

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

   procedure Send_Body (Packet_Body : Bytes) is
      Check  : constant Unsigned_16 := Checksum (Packet_Body);
      Packet : constant Bytes :=
        (16#FA#, 16#FB#, Unsigned_8 (Packet_Body'Length + 2)) & Packet_Body &
        (Unsigned_8 (Check / 256), Unsigned_8 (Check mod 256));
      Buffer : Stream_Element_Array (1 .. Packet'Length);
   begin
      for I in Packet'Range loop
         Buffer (Stream_Element_Offset (I - Packet'First + 1)) := Stream_Element (Packet (I));
      end loop;
      Write (Channel.all, Buffer);
   end Send_Body;

   procedure Send (Command : Unsigned_8) is
   begin
      Send_Body ((0 => Command));
   end Send;

   --  An integer goes as its sign and its magnitude.
   procedure Send (Command : Unsigned_8; Argument : Integer) is
      Magnitude : constant Unsigned_16 := Unsigned_16 (abs Argument);
   begin
      Send_Body
        ((Command, (if Argument >= 0 then 16#3B# else 16#1B#),
          Unsigned_8 (Magnitude mod 256), Unsigned_8 (Magnitude / 256)));
   end Send;

   function Next_Byte return Unsigned_8 is
      Result : Unsigned_8;
   begin
      Unsigned_8'Read (Channel, Result);  --  raises End_Error when the robot closes the connection
      return Result;
   end Next_Byte;

   --  Id and data of the next packet; what is no packet is skipped.
   function Receive return Bytes is
      Before, Here : Unsigned_8 := 0;
   begin
      loop
         Here := Next_Byte;
         if Before = 16#FA# and then Here = 16#FB# then
            declare
               Count : constant Natural := Natural (Next_Byte);
            begin
               if Count >= 3 then
                  declare
                     Packet : Bytes (0 .. Count - 1);
                  begin
                     for B of Packet loop
                        B := Next_Byte;
                     end loop;
                     if Checksum (Packet (0 .. Count - 3)) =
                       Unsigned_16 (Packet (Count - 2)) * 256 + Unsigned_16 (Packet (Count - 1))
                     then
                        return Packet (0 .. Count - 3);
                     end if;
                  end;
               end if;
            end;
            Here := 0;
         end if;
         Before := Here;
      end loop;
   end Receive;

   procedure Shake_Hands is
   begin
      for Sync in Unsigned_8 range 0 .. 2 loop
         Send (Sync);
         while Receive (0) /= Sync loop
            null;
         end loop;
      end loop;
      Send (Open, 1);
   end Shake_Hands;

   function Word (Packet : Bytes; At_Byte : Natural) return Integer is
      Value : constant Unsigned_16 :=
        Unsigned_16 (Packet (At_Byte)) + Unsigned_16 (Packet (At_Byte + 1)) * 256;
   begin
      return (if Value < 32_768 then Integer (Value) else Integer (Value) - 65_536);
   end Word;

   type Ranges is array (0 .. 31) of Natural;

   --  What is known of the robot: written by who reads, read by who decides.
   protected State is
      procedure Take (Packet : Bytes);
      function X return Integer;
      function Y return Integer;
      function Ahead return Natural;
      function States return Natural;
   private
      X_Mm, Y_Mm : Integer := 0;
      Sonars     : Ranges  := (others => 5_000);
      Count      : Natural := 0;
   end State;

   protected body State is
      procedure Take (Packet : Bytes) is
      begin
         X_Mm := Word (Packet, 1);
         Y_Mm := Word (Packet, 3);
         for I in 0 .. Natural (Packet (19)) - 1 loop
            declare
               Number : constant Natural := Natural (Packet (20 + 3 * I));
            begin
               if Number in Sonars'Range then
                  Sonars (Number) := Natural (Packet (21 + 3 * I)) + 256 * Natural (Packet (22 + 3 * I));
               end if;
            end;
         end loop;
         Count := Count + 1;
      end Take;

      function X return Integer is (X_Mm);
      function Y return Integer is (Y_Mm);
      function States return Natural is (Count);
      function Ahead return Natural is
         Nearest : Natural := Natural'Last;
      begin
         for Number in 2 .. 5 loop
            Nearest := Natural'Min (Nearest, Sonars (Number));
         end loop;
         return Nearest;
      end Ahead;
   end State;

   --  Ends when the connection does.
   task type Reader;
   task body Reader is
   begin
      loop
         declare
            Packet : constant Bytes := Receive;
         begin
            if Packet (0) in 16#32# | 16#33# then
               State.Take (Packet);
            end if;
         end;
      end loop;
   exception
      when others =>
         null;
   end Reader;

   procedure Connect (Url : String) is
      use Ada.Strings.Fixed;
      First   : constant Positive := (if Index (Url, "tcp://") = Url'First then Url'First + 6 else Url'First);
      Colon   : constant Natural  := Index (Url (First .. Url'Last), ":");
      Host    : constant String   := Url (First .. (if Colon > 0 then Colon - 1 else Url'Last));
      Port    : constant Port_Type :=
        (if Colon > 0 then Port_Type'Value (Url (Colon + 1 .. Url'Last)) else 8_101);
      Address : Sock_Addr_Type;
   begin
      Address.Addr := Addresses (Get_Host_By_Name (Host), 1);
      Address.Port := Port;
      Create_Socket (Line);
      Connect_Socket (Line, Address);
      Set_Socket_Option (Line, IP_Protocol_For_TCP_Level, (No_Delay, True));
      Channel := Stream (Line);
   end Connect;

   procedure Run (Seconds : Duration) is
      Reading : Reader;
      Next    : Time          := Clock;
      Finish  : constant Time := Next + Seconds;
      Known   : Natural       := 0;
   begin
      Send (Enable, 1);
      Send (Sonar, 1);
      while Next < Finish loop
         delay until Next;
         Next := Next + 0.1;
         Send (Pulse);
         if State.Ahead > 1_000 then
            Send (Vel, 250);  --  mm/s
            Send (Rvel, 0);
         else
            Send (Vel, 0);
            Send (Rvel, 30);  --  degrees/s
         end if;
      end loop;
      Known := State.States;
      Put_Line ("at" & Integer'Image (State.X) & " mm," & Integer'Image (State.Y) & " mm after" &
                Natural'Image (Known) & " states");
      Send (Enable, 0);
      Send (Close);
      Shutdown_Socket (Line);
      if Known = 0 then
         Set_Exit_Status (Failure);
      end if;
   end Run;

begin
   Connect (if Argument_Count > 0 then Argument (1) else "tcp://localhost:8101");
   Shake_Hands;
   Put_Line ("connected");
   Run (if Argument_Count > 1 then Duration'Value (Argument (2)) else 30.0);
exception
   when Error : others =>
      Put_Line (Standard_Error, "the robot cannot be driven: " & Ada.Exceptions.Exception_Message (Error));
      Set_Exit_Status (Failure);
end Drive;
